#include "solvers/anchored_smoother.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include "frontends/radio_map/survey_positions.h"
#include "solvers/turning_walk.h"

namespace walkgraph {
namespace {

using testing::TurningWalk;

constexpr double kWaypointSigmaM = 0.3;

// Solved to the end: walks without noise come out exactly, whatever gain a walk with noise may do
// without.
std::optional<Trajectory> Smooth(const Truth& truth, const Evidence& evidence) {
  return AnchoredSmoother({}, {.tolerance_nats = 1e-9}, kWaypointSigmaM)
      .Smooth({}, truth, evidence);
}

double LargestError(const Trajectory& trajectory, const TurningWalk& walk) {
  double largest = 0;
  for (double s = 0; s <= TurningWalk::kEndS; s += TurningWalk::kStepS) {
    const Eigen::Vector2d at = trajectory.At(TurningWalk::At(s)).position_m.head<2>();
    largest = std::max(largest, (at - walk.Position(s)).norm());
  }
  return largest;
}

double SigmaAt(const Trajectory& trajectory, double seconds) {
  return std::sqrt(0.5 * trajectory.At(TurningWalk::At(seconds)).covariance_xy_m2.trace());
}

// The waypoints stand at both ends alone: the straight line between them misses the corner by
// metres, the smoother goes round it.
TEST(AnchoredSmootherTest, FindsTheTurnBetweenTwoWaypoints) {
  const TurningWalk walk;
  const Truth truth = walk.WaypointsAt({0, 22});
  const std::optional<Trajectory> trajectory = Smooth(truth, walk.evidence);
  ASSERT_TRUE(trajectory.has_value());
  EXPECT_LT(LargestError(*trajectory, walk), 1e-3);
  EXPECT_GT(LargestError(SurveyTrajectory(truth, walk.evidence), walk), 4.0);
  EXPECT_NEAR(trajectory->At(TurningWalk::At(5)).heading_rad, 0, 1e-3);
  EXPECT_NEAR(trajectory->At(TurningWalk::At(20)).heading_rad, std::numbers::pi / 2, 1e-3);
}

// A gyroscope that does not know where north is: the waypoints tell it.
TEST(AnchoredSmootherTest, NeedsNoAbsoluteHeading) {
  for (const double rotation_rad : {0.0, 1.0, 3.0, -2.0}) {
    TurningWalk walk(rotation_rad);
    walk.ForgetAbsoluteHeading();
    const std::optional<Trajectory> trajectory = Smooth(walk.WaypointsAt({0, 22}), walk.evidence);
    ASSERT_TRUE(trajectory.has_value());
    EXPECT_LT(LargestError(*trajectory, walk), 1e-3) << rotation_rad;
  }
}

TEST(AnchoredSmootherTest, CovarianceIsTheWaypointsAtThemAndGrowsBetween) {
  const TurningWalk walk;
  const std::optional<Trajectory> trajectory = Smooth(walk.WaypointsAt({0, 18, 22}), walk.evidence);
  ASSERT_TRUE(trajectory.has_value());
  for (const double s : {0.0, 18.0, 22.0}) {
    EXPECT_LT(SigmaAt(*trajectory, s), kWaypointSigmaM);
    EXPECT_GT(SigmaAt(*trajectory, s), 0.5 * kWaypointSigmaM);
  }
  for (double s = 0; s < 8; s += 1) {
    EXPECT_LT(SigmaAt(*trajectory, s), SigmaAt(*trajectory, s + 1));
  }
  for (double s = 10; s < 17; s += 1) {
    EXPECT_GT(SigmaAt(*trajectory, s), SigmaAt(*trajectory, s + 1));
  }
  // A longer way between waypoints leaves more open.
  EXPECT_GT(SigmaAt(*trajectory, 9), SigmaAt(*trajectory, 20));
}

TEST(AnchoredSmootherTest, AClockThatIsSetOtherwiseChangesNothing) {
  constexpr TimeNs kShift = 86'400 * kNsPerSecond + 123'456'789;
  const TurningWalk walk;
  const Truth truth = walk.WaypointsAt({1, 9, 21});
  Truth later_truth = truth;
  for (Waypoint& waypoint : later_truth.waypoints) waypoint.time_ns += kShift;
  Evidence later = walk.evidence;
  for (TimeNs* time :
       {&later.begin_ns, &later.end_ns, &later.motion[0].begin_ns, &later.motion[0].end_ns}) {
    *time += kShift;
  }
  for (StepEvidence& step : later.steps) {
    step.begin_ns += kShift;
    step.end_ns += kShift;
  }
  for (TimeNs& time : later.gyro_yaw_rad.time_ns) time += kShift;
  for (TimeNs& time : later.absolute_heading_rad.time_ns) time += kShift;

  const std::optional<Trajectory> before = Smooth(truth, walk.evidence);
  const std::optional<Trajectory> after = Smooth(later_truth, later);
  ASSERT_TRUE(before.has_value() && after.has_value());
  ASSERT_EQ(before->poses.size(), after->poses.size());
  for (std::size_t i = 0; i < before->poses.size(); ++i) {
    EXPECT_EQ(before->poses[i].time_ns + kShift, after->poses[i].time_ns);
    EXPECT_EQ(before->poses[i].position_m, after->poses[i].position_m);
    EXPECT_EQ(before->poses[i].covariance_xy_m2, after->poses[i].covariance_xy_m2);
  }
}

TEST(AnchoredSmootherTest, SpansTheWaypointsAndNoMore) {
  const TurningWalk walk;
  Truth truth = walk.WaypointsAt({2, 14});
  truth.waypoints[0].time_ns += 100'000'000;  // between two nodes
  const std::optional<Trajectory> trajectory = Smooth(truth, walk.evidence);
  ASSERT_TRUE(trajectory.has_value());
  EXPECT_EQ(trajectory->poses.front().time_ns, truth.waypoints[0].time_ns);
  EXPECT_EQ(trajectory->poses.back().time_ns, truth.waypoints[1].time_ns);
  for (std::size_t i = 1; i < trajectory->poses.size(); ++i) {
    EXPECT_GT(trajectory->poses[i].time_ns, trajectory->poses[i - 1].time_ns);
  }
}

TEST(AnchoredSmootherTest, HasNoAnswerWhereTheGraphHasNone) {
  TurningWalk walk;
  EXPECT_FALSE(Smooth({}, walk.evidence).has_value());
  EXPECT_FALSE(Smooth(walk.WaypointsAt({5}), walk.evidence).has_value());
  Truth stairs = walk.WaypointsAt({0, 10, 22});
  stairs.waypoints.back().floor = 1;
  EXPECT_FALSE(Smooth(stairs, walk.evidence).has_value());
  walk.evidence.steps.clear();
  EXPECT_FALSE(Smooth(walk.WaypointsAt({0, 22}), walk.evidence).has_value());
}

}  // namespace
}  // namespace walkgraph
