#include "eval/metrics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace walkgraph {
namespace {

PoseEstimate Pose(TimeNs time_ns, double x, double y, double variance) {
  PoseEstimate pose;
  pose.time_ns = time_ns;
  pose.position_m = {x, y, 0};
  pose.floor = 1;
  pose.covariance_xy_m2 = variance * Eigen::Matrix2d::Identity();
  return pose;
}

// Stands at the origin from 0 s to 10 s with a sigma of 2 m.
Trajectory StandingAtOrigin() { return {{Pose(0, 0, 0, 4), Pose(10 * kNsPerSecond, 0, 0, 4)}}; }

WaypointError Error(double metres) {
  WaypointError error;
  error.error_m = metres;
  return error;
}

TEST(Metrics, ErrorIsTheDistanceAtTheWaypointsTimeClampedAtTheEnds) {
  const Trajectory line = {{Pose(0, 0, 0, 1), Pose(10 * kNsPerSecond, 10, 0, 1)}};
  const Truth truth = {TruthFrame::kBuilding,
                       {{5 * kNsPerSecond, {5, 3}, 1},      // 5 m along the line, 3 m beside it
                        {-kNsPerSecond, {-4, -3}, 1},       // before the begin: from (0, 0)
                        {20 * kNsPerSecond, {10, 7}, 2}}};  // after the end: from (10, 0)
  const std::vector<WaypointError> errors = ErrorsAtWaypoints(line, truth, 0);
  ASSERT_EQ(errors.size(), 3u);
  EXPECT_NEAR(errors[0].error_m, 3, 1e-12);
  EXPECT_NEAR(errors[1].error_m, 5, 1e-12);
  EXPECT_NEAR(errors[2].error_m, 7, 1e-12);
  EXPECT_EQ(errors[0].floors_off, 0);
  EXPECT_EQ(errors[2].floors_off, 1);
}

TEST(Metrics, NeesCountsTheWaypointsOwnError) {
  const Truth truth = {TruthFrame::kBuilding, {{0, {3, 4}, 1}}};
  EXPECT_NEAR(ErrorsAtWaypoints(StandingAtOrigin(), truth, 0)[0].nees, 25.0 / 4, 1e-12);
  EXPECT_NEAR(ErrorsAtWaypoints(StandingAtOrigin(), truth, 1)[0].nees, 25.0 / 5, 1e-12);
}

TEST(Metrics, WithoutCovarianceThereIsNoNees) {
  const Trajectory bare = {{Pose(0, 0, 0, std::nan(""))}};
  const Truth truth = {TruthFrame::kBuilding, {{0, {3, 4}, 1}}};
  const ErrorSummary summary = Summarise(ErrorsAtWaypoints(bare, truth, 0.3));
  EXPECT_NEAR(summary.mean_m, 5, 1e-12);
  EXPECT_TRUE(std::isnan(summary.nees));
  EXPECT_TRUE(std::isnan(summary.coverage95));
}

TEST(Metrics, SummaryOfFiveErrorsByHand) {
  const ErrorSummary summary = Summarise({Error(4), Error(1), Error(3), Error(2), Error(10)});
  EXPECT_EQ(summary.n, 5);
  EXPECT_NEAR(summary.mean_m, 4, 1e-12);
  EXPECT_NEAR(summary.rmse_m, std::sqrt(130.0 / 5), 1e-12);
  EXPECT_NEAR(summary.median_m, 3, 1e-12);
  EXPECT_NEAR(summary.p75_m, 4, 1e-12);            // rank 3 of 0..4
  EXPECT_NEAR(summary.p90_m, 4 + 0.6 * 6, 1e-12);  // rank 3.6
  EXPECT_NEAR(summary.p95_m, 4 + 0.8 * 6, 1e-12);  // rank 3.8
  EXPECT_NEAR(summary.max_m, 10, 1e-12);
}

TEST(Metrics, EachFloorOffCostsFifteenMetresInTheCompetitionsScore) {
  std::vector<WaypointError> errors = {Error(4), Error(1), Error(3), Error(2), Error(10)};
  EXPECT_NEAR(Summarise(errors).ipin_m, 4, 1e-12);
  errors[1].floors_off = 2;  // 31: now 2, 3, 4, 10, 31
  EXPECT_NEAR(Summarise(errors).ipin_m, 10, 1e-12);
  EXPECT_NEAR(Summarise(errors).p75_m, 4, 1e-12);
}

TEST(Metrics, NoErrorsMakeNoNumbers) {
  const ErrorSummary summary = Summarise({});
  EXPECT_EQ(summary.n, 0);
  EXPECT_TRUE(std::isnan(summary.mean_m));
  EXPECT_TRUE(std::isnan(summary.max_m));
}

TEST(Metrics, CoverageCountsInsideTheEllipses) {
  // The 50 % and 95 % radii of a 2-D normal variable are 1.17741 and 2.44775 sigma (sigma 2 m
  // here).
  const Truth truth = {TruthFrame::kBuilding,
                       {{0, {2 * 1.177, 0}, 1},
                        {0, {2 * 1.178, 0}, 1},
                        {0, {0, 2 * 2.447}, 1},
                        {0, {0, 2 * 2.449}, 1}}};
  const ErrorSummary summary = Summarise(ErrorsAtWaypoints(StandingAtOrigin(), truth, 0));
  EXPECT_NEAR(summary.coverage50, 0.25, 1e-12);
  EXPECT_NEAR(summary.coverage95, 0.75, 1e-12);
}

TEST(Metrics, CoverageIsThatOfEstimatesThatClaimOne) {
  WaypointError with, without;
  with.error_m = without.error_m = 1;
  with.nees = 1;
  const ErrorSummary half = Summarise({with, without});
  EXPECT_EQ(half.coverage95, 1);
  EXPECT_EQ(half.nees, 1);
  // Two of five: where the method has nothing else, not what it is.
  const ErrorSummary few = Summarise({with, without, without, with, without});
  EXPECT_TRUE(std::isnan(few.coverage50));
  EXPECT_TRUE(std::isnan(few.coverage95));
  EXPECT_TRUE(std::isnan(few.nees));
  EXPECT_EQ(few.mean_m, 1);
}

TEST(Metrics, FixedPointIsOnItsFloorOnly) {
  const Truth truth = {TruthFrame::kBuilding, {{0, {3, 4}, 1}, {1, {0, 1}, 2}}};
  const std::vector<WaypointError> errors = ErrorsOfFixedPoint({0, 0}, 2, truth);
  EXPECT_NEAR(errors[0].error_m, 5, 1e-12);
  EXPECT_GT(errors[0].floors_off, 0);
  EXPECT_EQ(errors[1].floors_off, 0);
}

}  // namespace
}  // namespace walkgraph
