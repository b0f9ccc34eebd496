#include "frontends/radio_map/radio_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace walkgraph {
namespace {

constexpr double kHuge = 1e300;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const FieldGrid kGrid{{-10.0, 5.0}, 4.0, 9, 7};
// Where the spline is defined: one control point in from every side.
const Eigen::Vector2d kLow(-6.0, 9.0);
const Eigen::Vector2d kHigh(18.0, 25.0);

double Sum(const std::array<double, 16>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

std::vector<Eigen::Vector2d> RandomPositions(int count, double margin_m) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(kLow.x() - margin_m, kHigh.x() + margin_m);
  std::uniform_real_distribution<double> y(kLow.y() - margin_m, kHigh.y() + margin_m);
  std::vector<Eigen::Vector2d> positions;
  for (int i = 0; i < count; ++i) {
    const double px = x(random), py = y(random);
    positions.emplace_back(px, py);
  }
  return positions;
}

// A map of one transmitter with random control values inside a rectangle, and random silence.
RadioMap RandomMap() {
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  RadioMap map;
  map.grid = kGrid;
  RadioMap::TransmitterField field;
  field.transmitter = 4;
  field.column = 2;
  field.row = 1;
  field.columns = 4;
  field.rows = 3;
  field.background_mean_dbm = -91.0F;
  field.background_log_sigma = 2.0F;
  field.background_logit_hear = -5.0F;
  for (int i = 0; i < field.columns * field.rows; ++i) {
    field.mean_dbm.push_back(-60.0F + 8.0F * normal(random));
    field.log_sigma.push_back(1.5F + 0.2F * normal(random));
    field.logit_hear.push_back(normal(random));
  }
  map.fields.push_back(field);
  for (int i = 0; i < kGrid.columns * kGrid.rows; ++i) {
    map.silence_nats.push_back(10.0F + normal(random));
  }
  return map;
}

// A map whose only field covers the whole grid with mean_dbm = f(control point).
template <typename F>
RadioMap MapOf(F&& f) {
  RadioMap map;
  map.grid = kGrid;
  RadioMap::TransmitterField field;
  field.columns = kGrid.columns;
  field.rows = kGrid.rows;
  for (int r = 0; r < kGrid.rows; ++r) {
    for (int c = 0; c < kGrid.columns; ++c) {
      const Eigen::Vector2d at = kGrid.origin_m + kGrid.spacing_m * Eigen::Vector2d(c, r);
      field.mean_dbm.push_back(static_cast<float>(f(at)));
      field.log_sigma.push_back(0.0F);
      field.logit_hear.push_back(0.0F);
    }
  }
  map.fields.push_back(field);
  return map;
}

void ExpectSame(const FieldValue& a, const FieldValue& b) {
  EXPECT_DOUBLE_EQ(a.mean_dbm, b.mean_dbm);
  EXPECT_DOUBLE_EQ(a.log_sigma, b.log_sigma);
  EXPECT_DOUBLE_EQ(a.logit_hear, b.logit_hear);
}

TEST(FieldBasisTest, WeightsSumToOneAndDerivativesToZeroEverywhere) {
  for (const Eigen::Vector2d& at : RandomPositions(500, 20.0)) {
    const FieldBasis basis = EvaluateBasis(kGrid, at);
    EXPECT_NEAR(Sum(basis.weight), 1.0, 1e-14);
    EXPECT_NEAR(Sum(basis.d_dx), 0.0, 1e-14);
    EXPECT_NEAR(Sum(basis.d_dy), 0.0, 1e-14);
    EXPECT_GE(*std::min_element(basis.weight.begin(), basis.weight.end()), 0.0);
    EXPECT_GE(basis.column, 0);
    EXPECT_LE(basis.column + 4, kGrid.columns);
    EXPECT_GE(basis.row, 0);
    EXPECT_LE(basis.row + 4, kGrid.rows);
  }
}

// Greville: the uniform cubic B-spline of a linear function's samples is that function.
TEST(FieldBasisTest, ReproducesLinearFields) {
  const auto plane = [](const Eigen::Vector2d& p) { return -70.0 + 0.5 * p.x() - 0.25 * p.y(); };
  const RadioMap map = MapOf(plane);
  for (const Eigen::Vector2d& at : RandomPositions(200, -1e-9)) {
    const FieldValue value = map.Evaluate(0, EvaluateBasis(kGrid, at));
    EXPECT_NEAR(value.mean_dbm, plane(at), 1e-5);
    EXPECT_NEAR(value.d_mean.x(), 0.5, 1e-5);
    EXPECT_NEAR(value.d_mean.y(), -0.25, 1e-5);
  }
}

// A quadratic comes out raised by a constant: the spline is the function convolved with a kernel of
// variance spacing^2 / 3.
TEST(FieldBasisTest, SmoothsAQuadraticByAThirdOfTheSpacingSquared) {
  const RadioMap map = MapOf([](const Eigen::Vector2d& p) { return p.x() * p.x(); });
  for (const Eigen::Vector2d& at : RandomPositions(50, -1e-9)) {
    const FieldValue value = map.Evaluate(0, EvaluateBasis(kGrid, at));
    EXPECT_NEAR(value.mean_dbm, at.x() * at.x() + kGrid.spacing_m * kGrid.spacing_m / 3.0, 1e-3);
  }
}

TEST(FieldBasisTest, HoldsTheEdgeValueOutside) {
  const RadioMap map = RandomMap();
  for (const Eigen::Vector2d& at : RandomPositions(200, 30.0)) {
    const Eigen::Vector2d inside = at.cwiseMax(kLow).cwiseMin(kHigh);
    const FieldValue value = map.Evaluate(0, EvaluateBasis(kGrid, at));
    ExpectSame(value, map.Evaluate(0, EvaluateBasis(kGrid, inside)));
    if (at.x() != inside.x()) {
      EXPECT_EQ(value.d_mean.x(), 0.0);
    }
    if (at.y() != inside.y()) {
      EXPECT_EQ(value.d_mean.y(), 0.0);
    }
  }
}

TEST(FieldBasisTest, StaysFiniteForExtremePositions) {
  const RadioMap map = RandomMap();
  for (const double extreme : {kHuge, -kHuge, kInfinity, -kInfinity, kNaN}) {
    for (const Eigen::Vector2d& at : {Eigen::Vector2d(extreme, 12.0), Eigen::Vector2d(3.0, extreme),
                                      Eigen::Vector2d(extreme, extreme)}) {
      const FieldBasis basis = EvaluateBasis(kGrid, at);
      const FieldValue value = map.Evaluate(0, basis);
      EXPECT_TRUE(std::isfinite(value.mean_dbm) && std::isfinite(value.log_sigma) &&
                  std::isfinite(value.logit_hear));
      EXPECT_TRUE(value.d_mean.allFinite() && value.d_log_sigma.allFinite() &&
                  value.d_logit_hear.allFinite());
      EXPECT_TRUE(std::isfinite(map.Silence(basis).value));
    }
  }
}

TEST(RadioMapTest, GradientIsTheNumericDerivative) {
  const RadioMap map = RandomMap();
  constexpr double kStep = 1e-5;
  for (const Eigen::Vector2d& at : RandomPositions(200, -0.01)) {
    const FieldBasis basis = EvaluateBasis(kGrid, at);
    const FieldValue value = map.Evaluate(0, basis);
    const Eigen::Vector2d silence = map.Silence(basis).gradient;
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(axis);
      const FieldBasis ahead = EvaluateBasis(kGrid, at + step);
      const FieldBasis behind = EvaluateBasis(kGrid, at - step);
      const FieldValue a = map.Evaluate(0, ahead), b = map.Evaluate(0, behind);
      const double numeric_silence = map.Silence(ahead).value - map.Silence(behind).value;
      EXPECT_NEAR(value.d_mean(axis), (a.mean_dbm - b.mean_dbm) / (2 * kStep), 1e-6);
      EXPECT_NEAR(value.d_log_sigma(axis), (a.log_sigma - b.log_sigma) / (2 * kStep), 1e-6);
      EXPECT_NEAR(value.d_logit_hear(axis), (a.logit_hear - b.logit_hear) / (2 * kStep), 1e-6);
      EXPECT_NEAR(silence(axis), numeric_silence / (2 * kStep), 1e-6);
    }
  }
}

TEST(RadioMapTest, ValueWithoutGradientIsTheSame) {
  const RadioMap map = RandomMap();
  for (const Eigen::Vector2d& at : RandomPositions(200, 5.0)) {
    const FieldBasis basis = EvaluateBasis(kGrid, at);
    ExpectSame(map.Evaluate(0, basis), map.EvaluateValue(0, basis));
  }
}

// The rectangle is an economy of storage: a field stored on the whole grid, with the background
// written out, has the same values.
TEST(RadioMapTest, OutsideTheRectangleControlPointsAreBackground) {
  const RadioMap map = RandomMap();
  const RadioMap::TransmitterField& field = map.fields.front();
  RadioMap whole = map;
  RadioMap::TransmitterField& all = whole.fields.front();
  all.column = all.row = 0;
  all.columns = kGrid.columns;
  all.rows = kGrid.rows;
  const auto size = static_cast<std::size_t>(kGrid.columns * kGrid.rows);
  all.mean_dbm.assign(size, field.background_mean_dbm);
  all.log_sigma.assign(size, field.background_log_sigma);
  all.logit_hear.assign(size, field.background_logit_hear);
  for (int r = 0; r < field.rows; ++r) {
    for (int c = 0; c < field.columns; ++c) {
      const auto from = static_cast<std::size_t>(r * field.columns + c);
      const auto to = static_cast<std::size_t>((field.row + r) * kGrid.columns + field.column + c);
      all.mean_dbm[to] = field.mean_dbm[from];
      all.log_sigma[to] = field.log_sigma[from];
      all.logit_hear[to] = field.logit_hear[from];
    }
  }
  for (const Eigen::Vector2d& at : RandomPositions(300, 5.0)) {
    const FieldBasis basis = EvaluateBasis(kGrid, at);
    const FieldValue a = map.Evaluate(0, basis), b = whole.Evaluate(0, basis);
    EXPECT_NEAR(a.mean_dbm, b.mean_dbm, 1e-12);
    EXPECT_NEAR(a.log_sigma, b.log_sigma, 1e-12);
    EXPECT_NEAR(a.logit_hear, b.logit_hear, 1e-12);
    EXPECT_LT((a.d_mean - b.d_mean).norm(), 1e-12);
  }
  // Columns 2..5 of control points reach no farther than two spacings beyond the last.
  const FieldValue far = map.Evaluate(0, EvaluateBasis(kGrid, {18.0, 17.0}));
  EXPECT_EQ(far.mean_dbm, -91.0);
  EXPECT_EQ(far.log_sigma, 2.0);
  EXPECT_EQ(far.logit_hear, -5.0);
  EXPECT_EQ(far.d_mean, Eigen::Vector2d::Zero());
}

TEST(RadioMapTest, FindsFieldsByTransmitter) {
  RadioMap map;
  for (const std::uint32_t transmitter : {2U, 3U, 9U}) {
    map.fields.emplace_back().transmitter = transmitter;
  }
  EXPECT_EQ(map.FindField(2), 0);
  EXPECT_EQ(map.FindField(9), 2);
  for (const std::uint32_t missing : {0U, 4U, 10U}) EXPECT_EQ(map.FindField(missing), -1);
}

}  // namespace
}  // namespace walkgraph
