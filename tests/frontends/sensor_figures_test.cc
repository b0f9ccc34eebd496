#include "frontends/sensor_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "data/angle.h"
#include "frontends/build_evidence.h"
#include "frontends/synthetic_walk.h"

namespace walkgraph {
namespace {

// Evidence of somebody who takes `steps` steps of 0.7 m in half a second each, in a direction given
// step by step, whose absolute heading is wrong by a constant.
Evidence Reckoned(int steps, const std::function<double(int)>& heading_rad, double error_rad) {
  Evidence evidence;
  const TimeNs step_ns = kNsPerSecond / 2;
  for (int i = 0; i < steps; ++i) {
    const TimeNs begin = i * step_ns;
    evidence.steps.push_back({.begin_ns = begin, .end_ns = begin + step_ns, .length_m = 0.7});
    for (int part = 0; part < 10; ++part) {
      const TimeNs t = begin + part * step_ns / 10;
      evidence.gyro_yaw_rad.push_back(t, heading_rad(i) - 1.0);  // its zero means nothing
      evidence.absolute_heading_rad.push_back(t, heading_rad(i) - error_rad);
    }
  }
  evidence.end_ns = steps * step_ns;
  evidence.motion = {{.begin_ns = 0, .end_ns = evidence.end_ns, .state = MotionState::kWalking}};
  return evidence;
}

// Waypoints after every ten steps of a walker who really goes `true_step_m` a step.
Truth WaypointsEveryTenSteps(int steps, const std::function<double(int)>& heading_rad,
                             double true_step_m, double turned_rad) {
  Truth truth;
  Eigen::Vector2d position(3, 4);
  for (int i = 0; i <= steps; ++i) {
    if (i % 10 == 0) {
      truth.waypoints.push_back({.time_ns = i * kNsPerSecond / 2, .position = position});
    }
    const double heading = heading_rad(i) + turned_rad;
    position += true_step_m * Eigen::Vector2d(std::cos(heading), std::sin(heading));
  }
  return truth;
}

double Straight(int) { return -2.0; }
double Corner(int step) { return step < 20 ? 0.3 : 0.3 + std::numbers::pi / 2; }

TEST(SensorFigures, AConstantHeadingErrorIsTheSignedMeanAndTheRms) {
  const double error = DegreesToRadians(7);
  const double rotation = DegreesToRadians(30);
  const SensorFigures figures = ComputeSensorFigures(
      Reckoned(40, Corner, error), WaypointsEveryTenSteps(40, Corner, 0.7, rotation), rotation);
  ASSERT_EQ(figures.legs.size(), 4u);
  EXPECT_NEAR(figures.heading_walking.MeanRad(), error, 1e-9);
  EXPECT_NEAR(figures.heading_walking.RmsRad(), error, 1e-9);
  EXPECT_EQ(figures.heading_standing.samples, 0);
}

TEST(SensorFigures, DistanceRateIsTheRelativeErrorOfTheStepLength) {
  const SensorFigures figures = ComputeSensorFigures(
      Reckoned(40, Straight, 0), WaypointsEveryTenSteps(40, Straight, 0.8, 0), 0);
  for (const LegFigures& leg : figures.legs) {
    EXPECT_NEAR(leg.DistanceRate(), (0.7 - 0.8) / 0.8, 1e-9);
    EXPECT_NEAR(leg.steps, 10, 1e-9);
    EXPECT_TRUE(leg.straight);
  }
}

TEST(SensorFigures, OneRotationAndScaleExplainTheShapeOfAWalk) {
  const SensorFigures figures = ComputeSensorFigures(
      Reckoned(40, Corner, 0), WaypointsEveryTenSteps(40, Corner, 0.8, 2.0), 0);
  for (const LegFigures& leg : figures.legs) EXPECT_NEAR(leg.displacement_error, 0, 1e-9);
}

TEST(SensorFigures, AnEarlierWaypointTakesPartOfAStep) {
  Truth truth = WaypointsEveryTenSteps(20, Corner, 0.7, 0);
  truth.waypoints[1].time_ns -= kNsPerSecond / 8;  // a quarter of a step
  const SensorFigures figures = ComputeSensorFigures(Reckoned(20, Corner, 0), truth, 0);
  EXPECT_NEAR(figures.legs[0].steps, 9.75, 1e-9);
  EXPECT_NEAR(figures.legs[1].steps, 10.25, 1e-9);
}

TEST(SensorFigures, ACurvedLegIsNotStraightAndSaysNothingAboutHeading) {
  const auto curve = [](int step) { return 0.1 * step; };
  const SensorFigures figures =
      ComputeSensorFigures(Reckoned(40, curve, 0.2), WaypointsEveryTenSteps(40, curve, 0.7, 0), 0);
  for (const LegFigures& leg : figures.legs) EXPECT_FALSE(leg.straight);
  EXPECT_EQ(figures.heading_walking.samples, 0);
  EXPECT_TRUE(std::isnan(Summarize({figures}).distance_rate_mean));
}

TEST(SensorFigures, ShortLegsAndChangesOfFloorAreLeftOut) {
  Truth truth = WaypointsEveryTenSteps(40, Corner, 0.7, 0);
  truth.waypoints[2].floor = 1;
  EXPECT_EQ(ComputeSensorFigures(Reckoned(40, Corner, 0), truth, 0).legs.size(), 2u);
  truth = WaypointsEveryTenSteps(40, Corner, 0.1, 0);
  EXPECT_TRUE(ComputeSensorFigures(Reckoned(40, Corner, 0), truth, 0).legs.empty());
}

TEST(SensorFigures, EmptyInputsGiveEmptyFigures) {
  EXPECT_TRUE(ComputeSensorFigures({}, {}, 0).legs.empty());
  const SensorFigures no_sensors =
      ComputeSensorFigures({}, WaypointsEveryTenSteps(40, Corner, 0.7, 0), 0);
  ASSERT_EQ(no_sensors.legs.size(), 4u);
  EXPECT_EQ(no_sensors.legs[0].DistanceRate(), -1);
  EXPECT_TRUE(std::isnan(no_sensors.legs[0].displacement_error));
  EXPECT_EQ(Summarize({}).walks, 0);
}

TEST(SensorFigures, RefusesTruthInDegrees) {
  Truth truth = WaypointsEveryTenSteps(40, Corner, 0.7, 0);
  truth.frame = TruthFrame::kWgs84;
  EXPECT_THROW(ComputeSensorFigures({}, truth, 0), std::invalid_argument);
}

TEST(SensorFigures, TheSummaryPoolsLegsOfAllWalks) {
  const SensorFigures right = ComputeSensorFigures(Reckoned(40, Straight, 0),
                                                   WaypointsEveryTenSteps(40, Straight, 0.7, 0), 0);
  const SensorFigures half = ComputeSensorFigures(Reckoned(40, Straight, 0.2),
                                                  WaypointsEveryTenSteps(40, Straight, 1.4, 0), 0);
  const SensorSummary summary = Summarize({right, half});
  EXPECT_EQ(summary.walks, 2);
  EXPECT_EQ(summary.straight_legs, 8);
  EXPECT_NEAR(summary.distance_rate_mean, -0.25, 1e-9);
  EXPECT_NEAR(summary.distance_rate_std, 0.25, 1e-9);
  EXPECT_NEAR(summary.heading_walking.MeanRad(), 0.1, 1e-9);
  EXPECT_NEAR(summary.heading_walking.RmsRad(), 0.2 / std::numbers::sqrt2, 1e-9);
}

}  // namespace
}  // namespace walkgraph
