#include "frontends/radio_map/survey_positions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace walkgraph {
namespace {

constexpr TimeNs kStart = 1'560'000'000 * kNsPerSecond;

TimeNs At(double seconds) { return kStart + DurationNs(seconds); }

Truth TruthOf(const std::vector<Waypoint>& waypoints) { return {TruthFrame::kBuilding, waypoints}; }

// Steps of half a second and 0.7 m between two times.
void AddSteps(double begin_s, double end_s, Evidence* evidence) {
  for (double t = begin_s; t + 0.5 <= end_s + 1e-9; t += 0.5) {
    evidence->steps.push_back({At(t), At(t + 0.5), 0.7});
  }
}

Evidence EvidenceOf(double end_s) {
  Evidence evidence;
  evidence.begin_ns = kStart;
  evidence.end_ns = At(end_s);
  return evidence;
}

double SigmaAt(const Trajectory& trajectory, double seconds) {
  return std::sqrt(trajectory.At(At(seconds)).covariance_xy_m2(0, 0));
}

// 40 steps in the first ten seconds and the last ten, nothing for twenty seconds between: the
// person stands half way, however long.
TEST(SurveyTrajectoryTest, FollowsTheWalkedDistanceThroughAStop) {
  Evidence evidence = EvidenceOf(40);
  AddSteps(0, 10, &evidence);
  AddSteps(30, 40, &evidence);
  const Trajectory trajectory =
      SurveyTrajectory(TruthOf({{kStart, {0, 0}, 2}, {At(40), {20, 10}, 2}}), evidence);
  for (const double t : {10.0, 17.0, 29.5}) {
    EXPECT_LT((trajectory.At(At(t)).position_m.head<2>() - Eigen::Vector2d(10, 5)).norm(), 1e-6);
  }
  EXPECT_LT((trajectory.At(At(5)).position_m.head<2>() - Eigen::Vector2d(5, 2.5)).norm(), 1e-6);
  EXPECT_LT((trajectory.At(At(35)).position_m.head<2>() - Eigen::Vector2d(15, 7.5)).norm(), 1e-6);
  EXPECT_EQ(trajectory.poses.front().floor, 2);
}

// Only shares of a leg count: a wrong step length changes nothing.
TEST(SurveyTrajectoryTest, ScaleOfTheStepsDoesNotMatter) {
  Evidence evidence = EvidenceOf(20);
  AddSteps(2, 9, &evidence);
  AddSteps(15, 20, &evidence);
  const Truth truth = TruthOf({{At(1), {0, 0}, 0}, {At(19), {12, 0}, 0}});
  const Trajectory before = SurveyTrajectory(truth, evidence);
  for (StepEvidence& step : evidence.steps) step.length_m *= 1.7;
  const Trajectory after = SurveyTrajectory(truth, evidence);
  ASSERT_EQ(before.poses.size(), after.poses.size());
  for (std::size_t i = 0; i < before.poses.size(); ++i) {
    EXPECT_LT((before.poses[i].position_m - after.poses[i].position_m).norm(), 1e-9);
  }
}

TEST(SurveyTrajectoryTest, WithoutStepsGoesByTime) {
  Evidence evidence = EvidenceOf(30);
  AddSteps(10, 20, &evidence);  // the first leg has none
  const Trajectory trajectory = SurveyTrajectory(
      TruthOf({{kStart, {0, 0}, 0}, {At(8), {8, 0}, 0}, {At(20), {8, 12}, 0}}), evidence);
  EXPECT_NEAR(trajectory.At(At(2)).position_m.x(), 2.0, 1e-6);
  EXPECT_NEAR(trajectory.At(At(7)).position_m.x(), 7.0, 1e-6);
  EXPECT_NEAR(trajectory.At(At(15)).position_m.y(), 6.0, 1e-6);
}

TEST(SurveyTrajectoryTest, HasAPoseAtEveryWaypointStepAndSecond) {
  Evidence evidence = EvidenceOf(10);
  AddSteps(0.25, 10, &evidence);
  const Trajectory trajectory =
      SurveyTrajectory(TruthOf({{At(2.1), {0, 0}, 0}, {At(7.3), {5, 0}, 0}}), evidence);
  EXPECT_EQ(trajectory.poses.front().time_ns, At(2.1));
  EXPECT_EQ(trajectory.poses.back().time_ns, At(7.3));
  for (std::size_t i = 1; i < trajectory.poses.size(); ++i) {
    const double apart =
        SecondsBetween(trajectory.poses[i - 1].time_ns, trajectory.poses[i].time_ns);
    EXPECT_GT(apart, 0.0);
    EXPECT_LE(apart, 0.5 + 1e-9);
  }
}

TEST(SurveyTrajectoryTest, SpreadIsSmallestAtWaypointsAndLargestMidLeg) {
  Evidence evidence = EvidenceOf(50);
  AddSteps(0, 50, &evidence);
  const Trajectory trajectory = SurveyTrajectory(
      TruthOf({{kStart, {0, 0}, 0}, {At(40), {20, 0}, 0}, {At(50), {20, 5}, 0}}), evidence);
  const double own = SigmaAt(trajectory, 0);
  EXPECT_NEAR(SigmaAt(trajectory, 40), own, 1e-6);
  EXPECT_NEAR(SigmaAt(trajectory, 50), own, 1e-6);
  EXPECT_GT(SigmaAt(trajectory, 20), SigmaAt(trajectory, 10));
  EXPECT_NEAR(SigmaAt(trajectory, 10), SigmaAt(trajectory, 30), 1e-6);
  // A bridge's variance in the middle is proportional to its length: 20 m against 5 m.
  const double long_leg = std::pow(SigmaAt(trajectory, 20), 2) - own * own;
  const double short_leg = std::pow(SigmaAt(trajectory, 45), 2) - own * own;
  EXPECT_NEAR(long_leg / short_leg, 4.0, 1e-6);
}

TEST(SurveyTrajectoryTest, ToleratesDuplicateWaypointTimes) {
  Evidence evidence = EvidenceOf(20);
  AddSteps(0, 20, &evidence);
  const Truth truth = TruthOf({{kStart, {0, 0}, 0},
                               {kStart, {0.1, 0}, 0},
                               {At(10), {10, 0}, 0},
                               {At(10), {10.2, 0}, 1},
                               {At(20), {20, 0}, 1},
                               {At(20), {20.1, 0}, 1}});
  const Trajectory trajectory = SurveyTrajectory(truth, evidence);
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
    const PoseEstimate& pose = trajectory.poses[i];
    EXPECT_TRUE(pose.position_m.allFinite() && pose.covariance_xy_m2.allFinite());
    const double expected = SecondsBetween(kStart, pose.time_ns);
    EXPECT_NEAR(pose.position_m.x(), expected, 0.25);
    if (i > 0) {
      EXPECT_GT(pose.time_ns, trajectory.poses[i - 1].time_ns);
    }
  }
}

// The direction of a lane walked to and fro is unwrapped, as every trajectory's heading is: halfway
// between two poses it must not point somewhere else.
TEST(SurveyTrajectoryTest, HeadingIsThatOfTheLegAndUnwrapped) {
  Evidence evidence = EvidenceOf(30);
  AddSteps(0, 30, &evidence);
  const Trajectory trajectory = SurveyTrajectory(
      TruthOf({{kStart, {0, 0}, 0}, {At(10), {-10, 1}, 0}, {At(20), {-20, 0}, 0}}), evidence);
  EXPECT_NEAR(std::cos(trajectory.At(At(5)).heading_rad), std::cos(std::atan2(1, -10)), 1e-9);
  for (std::size_t i = 1; i < trajectory.poses.size(); ++i) {
    const double turn = trajectory.poses[i].heading_rad - trajectory.poses[i - 1].heading_rad;
    EXPECT_LE(std::abs(turn), std::numbers::pi);
  }
  EXPECT_NEAR(trajectory.poses.back().heading_rad - trajectory.poses.front().heading_rad,
              2 * std::atan2(1, 10), 1e-9);
}

TEST(SurveyTrajectoryTest, SaysNothingWithoutWaypoints) {
  EXPECT_TRUE(SurveyTrajectory(TruthOf({}), EvidenceOf(10)).empty());
  const Trajectory one = SurveyTrajectory(TruthOf({{At(3), {4, 5}, 1}}), EvidenceOf(10));
  ASSERT_EQ(one.poses.size(), 1U);
  EXPECT_EQ(one.poses[0].time_ns, At(3));
  EXPECT_EQ(one.poses[0].position_m.head<2>(), Eigen::Vector2d(4, 5));
}

}  // namespace
}  // namespace walkgraph
