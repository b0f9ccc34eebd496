#include "solvers/window_recovery.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "solvers/batch_smoother.h"
#include "solvers/synthetic_site.h"
#include "solvers/window_smoother.h"

namespace walkgraph {
namespace {

using testing::SyntheticSite;

const std::vector<Eigen::Vector2d> kLoop = {{6, 6}, {40, 6}, {40, 28}, {14, 28}};
constexpr double kMarginNats = 12;

struct Walked {
  explicit Walked(std::uint32_t seed) : synthetic(seed) {
    evidence = synthetic.Walk(kLoop, 0.1, 3.0, &truth);
    smoothed = BatchSmoother({}, {}).Estimate(synthetic.site, evidence).trajectory;
  }
  std::optional<Recovery> FindLost(const Trajectory& track) const {
    return FindLostTrack(synthetic.site, evidence, {}, {}, track, kMarginNats,
                         smoothed.poses.front().floor);
  }

  SyntheticSite synthetic;
  std::vector<Eigen::Vector2d> truth;
  Evidence evidence;
  Trajectory smoothed;
};

// The same walk at another end of the floor, where the map says something else.
Trajectory MirroredAbout(const Eigen::Vector2d& middle, Trajectory track) {
  for (PoseEstimate& pose : track.poses) {
    pose.position_m.head<2>() = 2 * middle - pose.position_m.head<2>();
    pose.heading_rad += 3.14159265358979;
  }
  return track;
}

TEST(WindowRecoveryTest, LeavesTheSmoothersOwnTrackAlone) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const Walked walked(seed);
    EXPECT_FALSE(walked.FindLost(walked.smoothed)) << "seed " << seed;
  }
}

TEST(WindowRecoveryTest, LeavesATrackAloneThatLeadsBackToTheBestMode) {
  const Walked walked(1);
  Trajectory shifted = walked.smoothed;
  for (PoseEstimate& pose : shifted.poses) pose.position_m.x() += 3.0;
  EXPECT_FALSE(walked.FindLost(shifted));
}

TEST(WindowRecoveryTest, KnowsNoBetterWithoutEvidenceOfAPlace) {
  Walked walked(1);
  walked.evidence.readings.clear();
  EXPECT_FALSE(walked.FindLost(MirroredAbout({25, 17}, walked.smoothed)));
}

TEST(WindowRecoveryTest, ARecoveryIsTheSmoothersSolution) {
  const Walked walked(1);
  const std::optional<Recovery> recovery =
      walked.FindLost(MirroredAbout({25, 17}, walked.smoothed));
  ASSERT_TRUE(recovery);
  const WalkGraph& walk = recovery->walk;
  Eigen::VectorXd values = walk.prior_values;
  std::vector<int> blocks;
  for (std::size_t b = 0; b < walk.graph.blocks().size(); ++b)
    blocks.push_back(static_cast<int>(b));
  MoveTo(*recovery, walk.graph, blocks, &values);
  for (std::size_t node = 0; node < walk.node_ns.size(); ++node) {
    const Eigen::Vector2d position =
        values.segment<2>(walk.graph.block(walk.position[node]).offset);
    const Eigen::Vector2d expected = walked.smoothed.At(walk.node_ns[node]).position_m.head<2>();
    EXPECT_LT((position - expected).norm(), 0.05);
  }
  // One prior on each kind of state, as loose as promised.
  const LinearPrior prior = PriorFrom(*recovery, walk.graph, blocks, values);
  const Eigen::Matrix2d& first =
      recovery->mode.uncertainty.covariance[static_cast<std::size_t>(walk.position[0])];
  ASSERT_EQ(prior.blocks.front(), walk.position[0]);
  EXPECT_NEAR(prior.jacobian(0, 0), 0.5 / std::sqrt(first.diagonal().maxCoeff()), 1e-9);
  EXPECT_EQ(prior.residual.norm(), 0);
}

}  // namespace
}  // namespace walkgraph
