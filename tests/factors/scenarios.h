#ifndef WALKGRAPH_TESTS_FACTORS_SCENARIOS_H_
#define WALKGRAPH_TESTS_FACTORS_SCENARIOS_H_

#include <ceres/cost_function.h>

#include <Eigen/Core>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "factors/cost.h"
#include "factors/registry.h"
#include "factors/state_blocks.h"

namespace walkgraph::testing {

// A turn by quarters and a shift of everything that has a place or a direction. Quarters, because a
// radio map's grid has axes.
struct Motion {
  int quarters = 0;
  Eigen::Vector2d shift_m = Eigen::Vector2d::Zero();

  double angle_rad() const { return 0.5 * std::numbers::pi * quarters; }
  Eigen::Vector2d Turn(const Eigen::Vector2d& v) const {
    Eigen::Vector2d turned = v;
    for (int q = 0; q < quarters; ++q) turned = Eigen::Vector2d(-turned.y(), turned.x());
    return turned;
  }
  Eigen::Vector2d Move(const Eigen::Vector2d& p) const { return Turn(p) + shift_m; }
};

// What the typed suite needs to know of a factor type. Each specialisation has
//   kGaussian          whether its rows are whitened measurements with a density of their own
//   kinds()            of its blocks
//   Scenario(random)   a factor of that type
//   Cost()             the factor as it is used
//   Twin()             the same by automatic differentiation
//   Predicted(random)  blocks at which the residual vanishes (kGaussian only)
//   Moved(motion)      the factor with building, map, north and tags moved
//   Sampled(random)    blocks drawn from the factor's own noise model (kGaussian only)
template <typename Factor>
struct Scenario;

using Blocks = std::vector<Eigen::VectorXd>;
using Random = std::mt19937;

inline double Normal(Random* random, double sigma = 1) {
  return std::normal_distribution<double>(0, sigma)(*random);
}
// Every fourth heading is exactly pi or -pi.
inline double RandomHeading(Random* random) {
  switch ((*random)() % 8) {
    case 0:
      return std::numbers::pi;
    case 1:
      return -std::numbers::pi;
    default:
      return std::uniform_real_distribution<double>(-std::numbers::pi, std::numbers::pi)(*random);
  }
}
inline Eigen::Vector2d RandomPlace(Random* random) {
  std::uniform_real_distribution<double> coordinate(5, 25);
  const double x = coordinate(*random), y = coordinate(*random);
  return {x, y};
}
inline Eigen::VectorXd Scalar(double value) { return Eigen::VectorXd::Constant(1, value); }

// What most scenarios share: a factor struct with operator() and LogNormaliser.
template <typename Factor>
struct StructScenario {
  static constexpr bool kGaussian = true;
  Factor factor;
  std::unique_ptr<ceres::CostFunction> Cost() const { return MakeCost(factor); }
  std::unique_ptr<ceres::CostFunction> Twin() const { return MakeAutoDiffCost(factor); }
};

template <>
struct Scenario<StepFactor> : StructScenario<StepFactor> {
  static std::vector<BlockKind> kinds() {
    return {BlockKind::kPosition, BlockKind::kHeading, BlockKind::kPosition, BlockKind::kHeading,
            BlockKind::kStepScale};
  }
  explicit Scenario(Random* random)
      : StructScenario{{0.7 + 0.1 * Normal(random), 0.1 + 0.05 * std::abs(Normal(random)), 0.2}} {}
  Blocks Predicted(Random* random) const { return Draw(random, 0); }
  Blocks Sampled(Random* random) const { return Draw(random, 1); }
  Scenario Moved(const Motion&) const { return *this; }

 private:
  Blocks Draw(Random* random, double noise) const {
    const Eigen::Vector2d p0 = RandomPlace(random);
    const double h0 = RandomHeading(random), h1 = h0 + 0.3 * Normal(random), scale = 1.1;
    const double h = 0.5 * (h0 + h1);
    const double along = noise * Normal(random, factor.sigma_along_m);
    const double across = noise * Normal(random, factor.sigma_across_m);
    const Eigen::Vector2d p1 = factor.Predict(p0, h0, h1, scale) +
                               along * Eigen::Vector2d(std::cos(h), std::sin(h)) +
                               across * Eigen::Vector2d(-std::sin(h), std::cos(h));
    return {p0, Scalar(h0), p1, Scalar(h1), Scalar(scale)};
  }
};

template <>
struct Scenario<HeadingIncrementFactor> : StructScenario<HeadingIncrementFactor> {
  static std::vector<BlockKind> kinds() {
    return {BlockKind::kHeading, BlockKind::kHeading, BlockKind::kGyroBias};
  }
  explicit Scenario(Random* random) : StructScenario{{Normal(random), 0.6, 0.04}} {}
  Blocks Predicted(Random* random) const { return Draw(random, 0); }
  Blocks Sampled(Random* random) const { return Draw(random, factor.sigma_rad); }
  Scenario Moved(const Motion&) const { return *this; }

 private:
  Blocks Draw(Random* random, double noise) const {
    const double h0 = RandomHeading(random), bias = 0.02 * Normal(random);
    // A whole turn more is the same heading.
    const double h1 = factor.Predict(h0, bias) + noise * Normal(random) +
                      2 * std::numbers::pi * static_cast<double>((*random)() % 3);
    return {Scalar(h0), Scalar(h1), Scalar(bias)};
  }
};

template <>
struct Scenario<AbsoluteHeadingFactor> : StructScenario<AbsoluteHeadingFactor> {
  static std::vector<BlockKind> kinds() { return {BlockKind::kHeading, BlockKind::kHeadingOffset}; }
  explicit Scenario(Random* random) : StructScenario{{RandomHeading(random), 0.2}} {}
  Blocks Predicted(Random* random) const { return Draw(random, 0); }
  Blocks Sampled(Random* random) const { return Draw(random, factor.sigma_rad); }
  Scenario Moved(const Motion& motion) const {
    Scenario moved = *this;
    moved.factor.heading_rad += motion.angle_rad();
    return moved;
  }

 private:
  Blocks Draw(Random* random, double noise) const {
    const double offset = 0.2 * Normal(random);
    return {Scalar(factor.heading_rad + offset + noise * Normal(random)), Scalar(offset)};
  }
};

// Two blocks of a kind, the second predicted from the first.
template <typename Factor, BlockKind kKind>
struct PairScenario : StructScenario<Factor> {
  static std::vector<BlockKind> kinds() { return {kKind, kKind}; }
  Blocks Predicted(Random* random) const { return Draw(random, 0); }

 protected:
  Blocks Draw(Random* random, double sigma) const {
    constexpr int kSize = BlockSize(kKind);
    Eigen::VectorXd first(kSize), second(kSize);
    for (int i = 0; i < kSize; ++i) first[i] = 5 * Normal(random);
    if constexpr (kSize == 1) {
      second[0] = this->factor.Predict(first[0]);
    } else {
      second = this->factor.Predict(Eigen::Vector2d(first));
    }
    for (int i = 0; i < kSize; ++i) second[i] += Normal(random, 1.0) * sigma;
    return {first, second};
  }
};

template <>
struct Scenario<PositionHoldFactor> : PairScenario<PositionHoldFactor, BlockKind::kPosition> {
  explicit Scenario(Random* random) { factor = {0.05 + 0.01 * std::abs(Normal(random))}; }
  Blocks Sampled(Random* random) const { return Draw(random, factor.sigma_m); }
  Scenario Moved(const Motion&) const { return *this; }
};

template <>
struct Scenario<RandomWalkFactor> : PairScenario<RandomWalkFactor, BlockKind::kGyroBias> {
  explicit Scenario(Random*) { factor = RandomWalkFactor::FromRate(0.01, 20.0); }
  Blocks Sampled(Random* random) const { return Draw(random, 0.01 * std::sqrt(20.0)); }
  Scenario Moved(const Motion&) const { return *this; }
};

template <>
struct Scenario<MapErrorFactor<2>> : StructScenario<MapErrorFactor<2>> {
  static std::vector<BlockKind> kinds() {
    return {BlockKind::kMapError, BlockKind::kMapError, BlockKind::kMapError};
  }
  explicit Scenario(Random*) {
    factor.weight = {0.5, 0.4};
    factor.sigma_m = 1.5;
  }
  Blocks Predicted(Random* random) const { return Draw(random, 0); }
  Blocks Sampled(Random* random) const { return Draw(random, factor.sigma_m); }
  Scenario Moved(const Motion&) const { return *this; }

 private:
  Blocks Draw(Random* random, double sigma_m) const {
    const auto draw = [random](double s) {
      return Eigen::Vector2d(Normal(random, s), Normal(random, s));
    };
    const Eigen::Vector2d first = draw(3), second = draw(3);
    return {first, second,
            factor.weight[0] * first + factor.weight[1] * second + draw(1) * sigma_m};
  }
};

template <>
struct Scenario<StatePriorFactor> : StructScenario<StatePriorFactor> {
  static std::vector<BlockKind> kinds() { return {BlockKind::kStepScale}; }
  explicit Scenario(Random* random) : StructScenario{{1.0 + 0.1 * Normal(random), 0.1}} {}
  Blocks Predicted(Random*) const { return {Scalar(factor.mean)}; }
  Blocks Sampled(Random* random) const {
    return {Scalar(factor.mean + Normal(random, factor.sigma))};
  }
  Scenario Moved(const Motion&) const { return *this; }
};

template <>
struct Scenario<PositionAnchorFactor> : StructScenario<PositionAnchorFactor> {
  static std::vector<BlockKind> kinds() { return {BlockKind::kPosition}; }
  explicit Scenario(Random* random) {
    const Eigen::Vector2d at = RandomPlace(random);
    factor = {at.x(), at.y(), 0.5};
  }
  Blocks Predicted(Random*) const { return {Eigen::Vector2d(factor.x_m, factor.y_m)}; }
  Blocks Sampled(Random* random) const {
    return {Eigen::Vector2d(factor.x_m + Normal(random, 0.5), factor.y_m + Normal(random, 0.5))};
  }
  Scenario Moved(const Motion& motion) const {
    Scenario moved = *this;
    const Eigen::Vector2d at = motion.Move({factor.x_m, factor.y_m});
    moved.factor.x_m = at.x();
    moved.factor.y_m = at.y();
    return moved;
  }
};

template <>
struct Scenario<BarometricFactor> : StructScenario<BarometricFactor> {
  static std::vector<BlockKind> kinds() {
    return {BlockKind::kHeight, BlockKind::kBarometricOffset};
  }
  explicit Scenario(Random* random) : StructScenario{{300 + 10 * Normal(random), 0.13}} {}
  Blocks Predicted(Random* random) const { return Draw(random, 0); }
  Blocks Sampled(Random* random) const { return Draw(random, factor.sigma_m); }
  Scenario Moved(const Motion&) const { return *this; }

 private:
  Blocks Draw(Random* random, double noise) const {
    const double z = 5 * Normal(random);
    return {Scalar(z), Scalar(factor.Predict(z) + noise * Normal(random))};
  }
};

template <>
struct Scenario<LevelFactor> : StructScenario<LevelFactor> {
  static std::vector<BlockKind> kinds() { return {BlockKind::kHeight}; }
  explicit Scenario(Random* random) : StructScenario{{3 * Normal(random), 0.15}} {}
  Blocks Predicted(Random*) const { return {Scalar(factor.height_m)}; }
  Blocks Sampled(Random* random) const {
    return {Scalar(factor.height_m + Normal(random, factor.sigma_m))};
  }
  Scenario Moved(const Motion&) const { return *this; }
};

// An L of two halls in a box of 30 m.
template <>
struct Scenario<AreaFactor> : StructScenario<AreaFactor> {
  static constexpr bool kGaussian = false;
  static std::vector<BlockKind> kinds() { return {BlockKind::kPosition}; }
  static Floor Halls(const Motion& motion) {
    Floor floor;
    floor.outline.emplace_back();
    for (const Eigen::Vector2d& corner :
         {Eigen::Vector2d(4, 4), {26, 4}, {26, 9}, {10, 9}, {10, 26}, {4, 26}}) {
      floor.outline.back().push_back(motion.Move(corner));
    }
    return floor;
  }
  explicit Scenario(Random* /*random*/, const Motion& motion = {})
      : StructScenario{{AreaField(WalkableRaster(Halls(motion), 0.5)), 0.7}} {}
  Scenario Moved(const Motion& motion) const { return Scenario(nullptr, motion); }
};

}  // namespace walkgraph::testing

#endif  // WALKGRAPH_TESTS_FACTORS_SCENARIOS_H_
