#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "data/angle.h"
#include "data/building.h"
#include "data/trajectory.h"

namespace walkgraph {
namespace {

// Lengths of one degree of latitude and longitude on WGS84 at 45 degrees north, as tabulated
// (111131.75 m and 78846.81 m): an independent check of scale and axes.
TEST(Wgs84ToBuilding, HasTheScaleOfTheEllipsoid) {
  const GeoReference origin{45.0, 7.0, 0.0};
  const double step_deg = 0.001;
  const Eigen::Vector2d north = Wgs84ToBuilding(45.0 + step_deg, 7.0, origin);
  EXPECT_NEAR(north.x(), 0.0, 1e-6);
  EXPECT_NEAR(north.y(), 111.13175, 2e-3);
  const Eigen::Vector2d east = Wgs84ToBuilding(45.0, 7.0 + step_deg, origin);
  EXPECT_NEAR(east.x(), 78.84681, 1e-4);
}

// A point's coordinates may not depend on which origin it was reached through.
TEST(Wgs84ToBuilding, KeepsDistancesOverAKilometre) {
  const GeoReference a{49.46, 11.11, 0.0};
  const GeoReference b{49.465, 11.115, 0.7};
  const double distance_a =
      (Wgs84ToBuilding(49.463, 11.118, a) - Wgs84ToBuilding(49.4605, 11.1105, a)).norm();
  const double distance_b =
      (Wgs84ToBuilding(49.463, 11.118, b) - Wgs84ToBuilding(49.4605, 11.1105, b)).norm();
  EXPECT_NEAR(distance_a, distance_b, 1e-3);
}

TEST(BuildingToWgs84, IsTheInverse) {
  for (const GeoReference& origin :
       {GeoReference{49.4613, 11.111, 0.36}, GeoReference{-60.0, 179.9, -2.0}}) {
    for (const Eigen::Vector2d& point :
         {Eigen::Vector2d(0, 0), Eigen::Vector2d(44, -24), Eigen::Vector2d(-700, 650)}) {
      const Eigen::Vector2d degrees = BuildingToWgs84(point, origin);
      EXPECT_LT((Wgs84ToBuilding(degrees.x(), degrees.y(), origin) - point).norm(), 1e-6);
    }
  }
}

TEST(ToBuildingFrame, NeedsAnOriginForWgs84Only) {
  Truth truth;
  truth.waypoints = {{0, {1, 2}, 0}};
  EXPECT_EQ(ToBuildingFrame(truth, {}).waypoints[0].position, Eigen::Vector2d(1, 2));
  truth.frame = TruthFrame::kWgs84;
  EXPECT_THROW(ToBuildingFrame(truth, {}), std::invalid_argument);
}

TEST(InsidePolygons, CountsHolesAsOutside) {
  const Polygon square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const Polygon hole = {{4, 4}, {6, 4}, {6, 6}, {4, 6}};
  EXPECT_TRUE(InsidePolygons({square, hole}, {2, 5}));
  EXPECT_FALSE(InsidePolygons({square, hole}, {5, 5}));
  EXPECT_FALSE(InsidePolygons({square, hole}, {11, 5}));
  EXPECT_FALSE(InsidePolygons({}, {0, 0}));
}

Trajectory TwoPoses() {
  Trajectory trajectory;
  trajectory.poses.resize(2);
  PoseEstimate& a = trajectory.poses[0];
  PoseEstimate& b = trajectory.poses[1];
  b.time_ns = 4 * kNsPerSecond;
  b.position_m = {8, -4, 2};
  b.floor = 1;
  b.heading_rad = 7.0;  // unwrapped: more than a turn from the first
  a.covariance_xy_m2 = Eigen::Matrix2d::Identity();
  b.covariance_xy_m2 = 3 * Eigen::Matrix2d::Identity();
  return trajectory;
}

TEST(Trajectory, IsLinearBetweenPosesAndClampedOutside) {
  const Trajectory trajectory = TwoPoses();
  const PoseEstimate quarter = trajectory.At(kNsPerSecond);
  EXPECT_TRUE(quarter.position_m.isApprox(Eigen::Vector3d(2, -1, 0.5)));
  EXPECT_DOUBLE_EQ(quarter.heading_rad, 1.75);
  EXPECT_DOUBLE_EQ(quarter.covariance_xy_m2(0, 0), 1.5);
  EXPECT_EQ(quarter.floor, 0);
  EXPECT_EQ(trajectory.At(3 * kNsPerSecond).floor, 1);
  EXPECT_EQ(trajectory.At(-kNsPerSecond).position_m, Eigen::Vector3d::Zero());
  EXPECT_EQ(trajectory.At(9 * kNsPerSecond).position_m, Eigen::Vector3d(8, -4, 2));
  EXPECT_EQ(trajectory.At(9 * kNsPerSecond).time_ns, 9 * kNsPerSecond);
  EXPECT_THROW(Trajectory().At(0), std::logic_error);
}

TEST(WrapAngle, FindsTheEquivalentInOneTurn) {
  for (double angle = -20; angle < 20; angle += 0.37) {
    const double wrapped = WrapAngle(angle);
    EXPECT_LE(std::abs(wrapped), std::numbers::pi + 1e-12);
    EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-12);
    EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-12);
  }
}

}  // namespace
}  // namespace walkgraph
