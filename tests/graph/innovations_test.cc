#include "graph/innovations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "factors/absolute_heading.h"
#include "factors/position_hold.h"
#include "factors/prior.h"

namespace walkgraph {
namespace {

constexpr double kRelative = 1e-12;

GraphPart PartOf(const FactorGraph& graph, std::vector<int> factors) {
  GraphPart part;
  part.blocks.resize(graph.blocks().size());
  std::iota(part.blocks.begin(), part.blocks.end(), 0);
  part.factors = std::move(factors);
  return part;
}

// A Kalman filter's: after a step of variance q^2 from a position known to s, a reading of sigma r
// is expected within s^2 + q^2 + r^2.
TEST(ComputeInnovations, IsAKalmanFiltersAfterAStep) {
  constexpr double kStart = 2.0, kStep = 0.7, kReading = 1.5;
  FactorGraph graph;
  const Eigen::Vector2d from(3, -4), read(5, 1);
  const int before = graph.AddBlock({BlockKind::kPosition, 0}, 0, from);
  const int after = graph.AddBlock({BlockKind::kPosition, 1}, 1, from);
  const int start =
      graph.AddFactor(MakeGraphFactor(PositionAnchorFactor{from.x(), from.y(), kStart}, {before}));
  const int hold = graph.AddFactor(MakeGraphFactor(PositionHoldFactor{kStep}, {before, after}));
  const int reading =
      graph.AddFactor(MakeGraphFactor(PositionAnchorFactor{read.x(), read.y(), kReading}, {after}));

  const auto found = ComputeInnovations(graph, PartOf(graph, {start, hold}), {reading});
  ASSERT_EQ(found.size(), 1U);
  const double variance = kStart * kStart + kStep * kStep + kReading * kReading;
  EXPECT_NEAR(found[0].mean_squared_whitened, (read - from).squaredNorm() / variance / 2,
              kRelative);
  EXPECT_EQ(found[0].type, PositionAnchorFactor::kName);
  EXPECT_EQ(found[0].count, 1);
  EXPECT_EQ(found[0].dimension, 2);
}

// Heading and offset are unknown apart and, after a first compass reading, known together: a second
// one is expected within S r^2 / (S + r^2) + r^2, where S is the variance of their sum before. What
// is expected of the sum needs their covariance, not their variances alone.
TEST(ComputeInnovations, KnowsWhatBlocksHaveInCommon) {
  constexpr double kHeading = 0.8, kOffset = 0.5, kSigma = 0.2, kFirst = 0.6, kSecond = 0.1;
  FactorGraph graph;
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(1);
  const int heading = graph.AddBlock({BlockKind::kHeading, 0}, 0, zero);
  const int offset = graph.AddBlock({BlockKind::kHeadingOffset, 0}, 0, zero);
  const int heading_prior =
      graph.AddFactor(MakeGraphFactor(StatePriorFactor{0, kHeading}, {heading}));
  const int offset_prior = graph.AddFactor(MakeGraphFactor(StatePriorFactor{0, kOffset}, {offset}));
  const int first =
      graph.AddFactor(MakeGraphFactor(AbsoluteHeadingFactor{kFirst, kSigma}, {heading, offset}));
  const int second =
      graph.AddFactor(MakeGraphFactor(AbsoluteHeadingFactor{kSecond, kSigma}, {heading, offset}));
  const double sum = kHeading * kHeading + kOffset * kOffset, noise = kSigma * kSigma;
  const double gain = kFirst / (sum + noise);
  *graph.value(heading) = gain * kHeading * kHeading;
  *graph.value(offset) = -gain * kOffset * kOffset;

  const auto found =
      ComputeInnovations(graph, PartOf(graph, {heading_prior, offset_prior, first}), {second});
  ASSERT_EQ(found.size(), 1U);
  const double off = gain * sum - kSecond;
  EXPECT_NEAR(found[0].mean_squared_whitened, off * off / (sum * noise / (sum + noise) + noise),
              kRelative);
}

// A reading whose squares count only in part is judged as it was measured.
TEST(ComputeInnovations, TakesTheWeightOut) {
  FactorGraph graph;
  const int state = graph.AddBlock({BlockKind::kStepScale, 0}, 0, Eigen::VectorXd::Ones(1));
  const int prior = graph.AddFactor(MakeGraphFactor(StatePriorFactor{1, 0.3}, {state}));
  GraphFactor half = MakeGraphFactor(StatePriorFactor{2, std::sqrt(2.0) * 0.4}, {state});
  half.weight = 0.5;
  const int reading = graph.AddFactor(std::move(half));
  const auto found = ComputeInnovations(graph, PartOf(graph, {prior}), {reading});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].mean_squared_whitened, 1 / (0.3 * 0.3 + 0.4 * 0.4), kRelative);
}

TEST(ComputeInnovations, LeavesOutWhatMeasuresNothing) {
  FactorGraph graph;
  const int state = graph.AddBlock({BlockKind::kStepScale, 0}, 0, Eigen::VectorXd::Ones(1));
  const int prior = graph.AddFactor(MakeGraphFactor(StatePriorFactor{1, 0.3}, {state}));
  GraphFactor silent = MakeGraphFactor(StatePriorFactor{2, 0.4}, {state});
  silent.whitened_rows = 0;
  const int factor = graph.AddFactor(std::move(silent));
  EXPECT_TRUE(ComputeInnovations(graph, PartOf(graph, {prior}), {factor}).empty());
  EXPECT_TRUE(ComputeInnovations(graph, PartOf(graph, {prior}), {}).empty());
}

}  // namespace
}  // namespace walkgraph
