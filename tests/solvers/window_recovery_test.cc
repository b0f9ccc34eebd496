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

struct Walked {
  explicit Walked(std::uint32_t seed) : synthetic(seed) {
    evidence = synthetic.Walk(kLoop, 0.1, 3.0, &truth);
    smoothed = BatchSmoother({}, {}).Estimate(synthetic.site, evidence).trajectory;
  }
  std::optional<Stretch> Smooth(const std::vector<Trajectory>& tracks) const {
    return SmoothStretch(synthetic.site, evidence, {}, {}, tracks, evidence.begin_ns,
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

TEST(WindowRecoveryTest, KnowsTheBestModeAmongTheTracks) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const Walked walked(seed);
    Trajectory shifted = walked.smoothed;  // leads back to it
    for (PoseEstimate& pose : shifted.poses) pose.position_m.x() += 3.0;
    const std::optional<Stretch> stretch =
        walked.Smooth({MirroredAbout({25, 17}, walked.smoothed), walked.smoothed, shifted});
    ASSERT_TRUE(stretch);
    EXPECT_NE(stretch->tracks[0].mode, 0) << "seed " << seed;
    EXPECT_EQ(stretch->tracks[1].mode, 0) << "seed " << seed;
    EXPECT_TRUE(stretch->tracks[1].at) << "seed " << seed;
    EXPECT_EQ(stretch->tracks[2].mode, 0) << "seed " << seed;
    EXPECT_FALSE(stretch->tracks[2].at) << "seed " << seed;
  }
}

TEST(WindowRecoveryTest, KnowsNothingWithoutEvidenceOfAPlace) {
  Walked walked(1);
  walked.evidence.readings.clear();
  EXPECT_FALSE(walked.Smooth({MirroredAbout({25, 17}, walked.smoothed)}));
}

TEST(WindowRecoveryTest, MovesAWindowToTheSmoothersSolution) {
  const Walked walked(1);
  const std::optional<Stretch> stretch = walked.Smooth({MirroredAbout({25, 17}, walked.smoothed)});
  ASSERT_TRUE(stretch);
  const Mode& mode = stretch->modes.front();
  const WalkGraph& walk = stretch->walk;
  Eigen::VectorXd values = walk.prior_values;
  std::vector<int> blocks;
  for (std::size_t b = 0; b < walk.graph.blocks().size(); ++b)
    blocks.push_back(static_cast<int>(b));
  MoveTo(walk, mode, walk.graph, blocks, &values);
  for (std::size_t node = 0; node < walk.node_ns.size(); ++node) {
    const Eigen::Vector2d position =
        values.segment<2>(walk.graph.block(walk.position[node]).offset);
    const Eigen::Vector2d expected = walked.smoothed.At(walk.node_ns[node]).position_m.head<2>();
    EXPECT_LT((position - expected).norm(), 0.05);
  }
  // One prior on each kind of state, as loose as promised.
  const LinearPrior prior = PriorFrom(walk, mode, walk.graph, blocks, values);
  const Eigen::Matrix2d& first =
      mode.uncertainty.covariance[static_cast<std::size_t>(walk.position[0])];
  ASSERT_EQ(prior.blocks.front(), walk.position[0]);
  EXPECT_NEAR(prior.jacobian(0, 0), 0.5 / std::sqrt(first.diagonal().maxCoeff()), 1e-9);
  EXPECT_EQ(prior.residual.norm(), 0);
}

}  // namespace
}  // namespace walkgraph
