// What hurts users of other smoothers, as named tests.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "graph/node_times.h"
#include "solvers/batch_smoother.h"
#include "solvers/graph_solver.h"
#include "solvers/synthetic_site.h"
#include "solvers/window_smoother.h"

namespace walkgraph {
namespace {

using testing::SyntheticSite;

const std::vector<Eigen::Vector2d> kCorner = {{8, 8}, {32, 8}, {32, 20}};

bool SameBytes(const Trajectory& a, const Trajectory& b) {
  return std::equal(a.poses.begin(), a.poses.end(), b.poses.begin(), b.poses.end(),
                    [](const PoseEstimate& x, const PoseEstimate& y) {
                      return x.time_ns == y.time_ns && x.position_m == y.position_m &&
                             x.heading_rad == y.heading_rad &&
                             x.covariance_xy_m2 == y.covariance_xy_m2;
                    });
}

void ExpectHonestlyFinite(const EstimateResult& result) {
  ASSERT_FALSE(result.trajectory.empty());
  for (const PoseEstimate& pose : result.trajectory.poses) {
    EXPECT_TRUE(pose.position_m.allFinite());
    EXPECT_TRUE(pose.covariance_xy_m2.allFinite());
    EXPECT_GT(pose.covariance_xy_m2.determinant(), 0);
  }
}

TEST(FieldRegressionTest, PermutedArrivalOrderGivesIdenticalBatchResults) {
  SyntheticSite synthetic(3);
  const Evidence evidence = synthetic.Walk(kCorner, 0.1, 3.0);
  Evidence permuted = evidence;
  std::shuffle(permuted.readings.begin(), permuted.readings.end(), std::mt19937(5));
  const BatchSmoother batch({}, {});
  EXPECT_TRUE(SameBytes(batch.Estimate(synthetic.site, evidence).trajectory,
                        batch.Estimate(synthetic.site, permuted).trajectory));
}

TEST(FieldRegressionTest, AngleOfExactlyPiIsOneHeadingAmongOthers) {
  SyntheticSite synthetic(4);
  std::vector<Eigen::Vector2d> truth;
  const Evidence evidence = synthetic.Walk({{40, 18}, {6, 18}}, 0.0, 3.0, &truth);
  const EstimateResult result = BatchSmoother({}, {}).Estimate(synthetic.site, evidence);
  EXPECT_NEAR(std::cos(result.trajectory.At(SyntheticSite::At(15)).heading_rad), -1.0, 0.05);
  EXPECT_LT((result.trajectory.At(SyntheticSite::At(15)).position_m.head<2>() - truth[15]).norm(),
            4.0);
}

TEST(FieldRegressionTest, TwoStampsTwoMillisecondsApartAreOneNode) {
  SyntheticSite synthetic(5);
  Evidence evidence = synthetic.Walk(kCorner, 0.1, 3.0);
  const EstimateResult before = BatchSmoother({}, {}).Estimate(synthetic.site, evidence);
  for (StepEvidence& step : evidence.steps) step.end_ns -= 2 * kNsPerMs;
  const std::vector<TimeNs> nodes = GraphNodeTimes(evidence);
  for (std::size_t i = 1; i < nodes.size(); ++i) EXPECT_GE(nodes[i] - nodes[i - 1], kMinNodeGapNs);
  const EstimateResult after = BatchSmoother({}, {}).Estimate(synthetic.site, evidence);
  ExpectHonestlyFinite(after);
  const TimeNs middle = SyntheticSite::At(15);
  EXPECT_LT(
      (before.trajectory.At(middle).position_m - after.trajectory.At(middle).position_m).norm(),
      0.1);
}

TEST(FieldRegressionTest, FailedSolveLeavesTheValuesAsTheyWere) {
  // A cost that cannot be evaluated anywhere.
  struct Broken : ceres::SizedCostFunction<1, 1> {
    bool Evaluate(const double* const*, double*, double**) const override { return false; }
  };
  FactorGraph graph;
  const int block = graph.AddBlock({BlockKind::kHeading, 0}, 0, Eigen::VectorXd::Ones(1));
  GraphFactor factor;
  factor.blocks = {block};
  factor.cost = std::make_unique<Broken>();
  graph.AddFactor(std::move(factor));
  EXPECT_FALSE(SolveGraph(WholeGraph(graph), {}, &graph).ok);
  EXPECT_EQ(*graph.value(block), 1.0);
}

TEST(FieldRegressionTest, StandingStillDoesNotStarveTheWindow) {
  SyntheticSite synthetic(6);
  Evidence evidence = synthetic.Walk(kCorner, 0.1, 3.0);
  evidence.end_ns += 60 * kNsPerSecond;
  evidence.motion.push_back(
      {evidence.motion.back().end_ns, evidence.end_ns, MotionState::kStanding});
  const EstimateResult result = WindowSmoother({}, {}, {}).Estimate(synthetic.site, evidence);
  ExpectHonestlyFinite(result);
  EXPECT_EQ(result.trajectory.poses.back().time_ns, evidence.end_ns);
  const auto stop = result.trajectory.At(SyntheticSite::At(37)).position_m;
  EXPECT_LT((result.trajectory.poses.back().position_m - stop).norm(), 2.0);
}

TEST(FieldRegressionTest, LateReadingsInsideTheWindowAreUsedAndOlderOnesCounted) {
  SyntheticSite synthetic(7);
  const Evidence evidence = synthetic.Walk(kCorner, 0.1, 3.0);
  const auto delayed = [&](double seconds) {
    Evidence late = evidence;
    for (RadioReading& reading : late.readings) reading.printed_ns += DurationNs(seconds);
    return WindowSmoother({}, {}, {}).Estimate(synthetic.site, late);
  };
  EXPECT_TRUE(delayed(5).messages.empty());
  // The window grows until the first scan arrives; those that follow come too late for their nodes.
  const EstimateResult late = delayed(14);
  ExpectHonestlyFinite(late);
  ASSERT_EQ(late.messages.size(), 1U);
  EXPECT_NE(late.messages[0].find("late factors dropped"), std::string::npos);
}

TEST(FieldRegressionTest, WithoutRadioOrTagsAWalkIsLaidAboutTheFloorAndNamesWhatIsMissing) {
  SyntheticSite synthetic(8);
  Evidence evidence = synthetic.Walk(kCorner, 0.1, 3.0);
  evidence.readings.clear();
  const BatchSmoother batch({}, {});
  const WindowSmoother window({}, {}, {});
  for (const Estimator* estimator : std::initializer_list<const Estimator*>{&batch, &window}) {
    const EstimateResult result = estimator->Estimate(synthetic.site, evidence);
    EXPECT_EQ(result.status, EstimateStatus::kUnobservable);
    ExpectHonestlyFinite(result);
    EXPECT_GT(result.trajectory.poses.front().covariance_xy_m2.trace(), 1e4);
    ASSERT_FALSE(result.messages.empty());
    EXPECT_NE(result.messages[0].find("position along (x, y)"), std::string::npos)
        << result.messages[0];
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const PoseEstimate& pose : result.trajectory.poses) mean += pose.position_m.head<2>();
    mean /= static_cast<double>(result.trajectory.poses.size());
    EXPECT_LT((mean - Eigen::Vector2d(24, 18)).norm(), 3.0);
  }
}

}  // namespace
}  // namespace walkgraph
