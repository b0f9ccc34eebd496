#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

#include "frontends/radio_map/hearing.h"

namespace walkgraph {
namespace {

const FieldGrid kGrid{{-8.0, -8.0}, 4.0, 20, 10};
constexpr double kBandwidthM = 2.5;
constexpr double kPriorSweeps = 1.0;

double Probability(double logit) { return 1.0 / (1.0 + std::exp(-logit)); }

RadioMap::TransmitterField WholeGrid() {
  RadioMap::TransmitterField field;
  field.columns = kGrid.columns;
  field.rows = kGrid.rows;
  return field;
}

// Sweeps every 10 cm along x = 0..30 m, y = 10 m; none on the right of that.
std::vector<Eigen::Vector2d> Sweeps() {
  std::vector<Eigen::Vector2d> sweeps;
  for (int i = 0; i <= 300; ++i) sweeps.emplace_back(0.1 * i, 10.0);
  return sweeps;
}

double ProbabilityAt(const RadioMap::TransmitterField& field, const Eigen::Vector2d& at) {
  const Eigen::Vector2d cell = (at - kGrid.origin_m) / kGrid.spacing_m;
  const auto row = static_cast<std::size_t>(std::lround(cell.y()));
  const auto column = static_cast<std::size_t>(std::lround(cell.x()));
  return Probability(field.logit_hear[row * static_cast<std::size_t>(kGrid.columns) + column]);
}

std::vector<std::size_t> Indices(std::size_t first, std::size_t last) {
  std::vector<std::size_t> indices(last - first);
  std::iota(indices.begin(), indices.end(), first);
  return indices;
}

TEST(HearingModelTest, WhereNobodySweptTheRateOfTheFloorHolds) {
  const HearingModel model(kGrid, Sweeps(), kBandwidthM, kPriorSweeps);
  RadioMap::TransmitterField field = WholeGrid();
  model.Fill(Indices(0, 43), &field);  // 43 of 301
  ASSERT_EQ(field.logit_hear.size(), 200U);
  EXPECT_NEAR(ProbabilityAt(field, {64, 24}), 43.0 / 301.0, 1e-6);
}

TEST(HearingModelTest, HeardByAllIsNearlyCertainAndHeardByNoneNearlyNever) {
  const HearingModel model(kGrid, Sweeps(), kBandwidthM, kPriorSweeps);
  RadioMap::TransmitterField field = WholeGrid();
  model.Fill(Indices(0, 150), &field);
  EXPECT_GT(ProbabilityAt(field, {4, 12}), 0.96);
  EXPECT_LT(ProbabilityAt(field, {28, 12}), 0.02);
  // Half way both kinds of sweep count alike.
  EXPECT_NEAR(ProbabilityAt(field, {16, 12}), 0.5, 0.2);
}

TEST(HearingModelTest, NothingIsCertain) {
  const HearingModel model(kGrid, Sweeps(), kBandwidthM, kPriorSweeps);
  RadioMap::TransmitterField always = WholeGrid(), never = WholeGrid();
  model.Fill(Indices(0, 301), &always);
  model.Fill({}, &never);
  for (const float logit : always.logit_hear) EXPECT_LE(Probability(logit), 0.98 + 1e-6);
  for (const float logit : never.logit_hear) EXPECT_GE(Probability(logit), 1e-4 - 1e-9);
  EXPECT_TRUE(std::isfinite(never.background_logit_hear));
}

// Far from where a transmitter was heard, among sweeps that all missed it, it is as unlikely as its
// background says: the rectangle's edge is no cliff.
TEST(HearingModelTest, BackgroundIsWhatSweepsThatMissedItSay) {
  std::vector<Eigen::Vector2d> sweeps;
  std::vector<std::size_t> heard;
  for (int x = 0; x <= 50; ++x) {
    for (int y = 0; y <= 25; ++y) {
      if (x < 8) heard.push_back(sweeps.size());
      sweeps.emplace_back(x, y);
    }
  }
  const HearingModel model(kGrid, sweeps, kBandwidthM, kPriorSweeps);
  RadioMap::TransmitterField field = WholeGrid();
  model.Fill(heard, &field);
  const double background = Probability(field.background_logit_hear);
  EXPECT_GT(ProbabilityAt(field, {32, 12}) / background, 0.5);
  EXPECT_LT(ProbabilityAt(field, {32, 12}) / background, 2.0);
  EXPECT_LT(background, 0.01);
}

TEST(HearingModelTest, CountsByTheGaussianKernel) {
  const std::vector<Eigen::Vector2d> sweeps{{0, 0}, {3, 0}, {0, 4}, {7, 7}};
  const HearingModel model(kGrid, sweeps, kBandwidthM, 2.0);
  RadioMap::TransmitterField field = WholeGrid();
  model.Fill({1, 3}, &field);
  const auto kernel = [](double distance_m) {
    return std::exp(-0.5 * std::pow(distance_m / kBandwidthM, 2));
  };
  const double heard = kernel(3) + kernel(std::sqrt(98.0));
  const double all = heard + 1 + kernel(4);
  EXPECT_NEAR(ProbabilityAt(field, {0, 0}), (heard + 2.0 * 0.5) / (all + 2.0), 1e-4);
}

TEST(HearingModelTest, WithoutSweepsEveryValueIsFinite) {
  const HearingModel model(kGrid, {}, kBandwidthM, kPriorSweeps);
  RadioMap::TransmitterField field = WholeGrid();
  model.Fill({}, &field);
  for (const float logit : field.logit_hear) EXPECT_TRUE(std::isfinite(logit));
}

TEST(SilenceFieldTest, IsTheSumOverAllTransmittersAtEveryControlPoint) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> column(0, kGrid.columns - 1), row(0, kGrid.rows - 1);
  std::normal_distribution<float> logit(-2.0F, 3.0F);
  std::vector<RadioMap::TransmitterField> fields(40);
  for (RadioMap::TransmitterField& field : fields) {
    field.column = column(random);
    field.row = row(random);
    field.columns = 1 + column(random) % (kGrid.columns - field.column);
    field.rows = 1 + row(random) % (kGrid.rows - field.row);
    field.background_logit_hear = logit(random) - 3.0F;
    for (int i = 0; i < field.columns * field.rows; ++i) field.logit_hear.push_back(logit(random));
  }
  const std::vector<float> silence = SilenceField(kGrid, fields);
  ASSERT_EQ(silence.size(), 200U);
  for (int r = 0; r < kGrid.rows; ++r) {
    for (int c = 0; c < kGrid.columns; ++c) {
      double nats = 0;
      for (const RadioMap::TransmitterField& field : fields) {
        const int fr = r - field.row, fc = c - field.column;
        const bool inside = fr >= 0 && fc >= 0 && fr < field.rows && fc < field.columns;
        const double own = inside
                               ? field.logit_hear[static_cast<std::size_t>(fr * field.columns + fc)]
                               : field.background_logit_hear;
        nats -= std::log(1.0 - Probability(own));
      }
      EXPECT_NEAR(silence[static_cast<std::size_t>(r * kGrid.columns + c)], nats, 1e-4);
    }
  }
}

}  // namespace
}  // namespace walkgraph
