#include <gtest/gtest.h>

#include <cmath>

#include "data/simulator/motion.h"
#include "data/simulator/scenarios.h"
#include "data/simulator/simulation.h"

namespace walkgraph {
namespace {

constexpr TimeNs kIntervalNs = 10 * kNsPerMs;

SimulationSettings CleanWalks() {
  SimulationSettings settings = CleanSettings();
  settings.walks.survey = 3;
  settings.walks.test = 3;
  settings.walks.connector_share = 0.7;
  return settings;
}

TEST(LiftRide, RisesWithinItsLimits) {
  const RideSettings settings;
  for (const double rise_m : {-7.0, -0.4, 0.4, 3.5, 21.0}) {
    const LiftRide ride(rise_m, settings);
    EXPECT_EQ(ride.HeightAt(0), 0.0);
    EXPECT_NEAR(ride.HeightAt(ride.duration_s()), rise_m, 1e-12);
    EXPECT_NEAR(ride.HeightAt(0.5 * ride.duration_s()), 0.5 * rise_m, 1e-9);
    constexpr double kDt = 1e-3;
    double fastest = 0;
    double hardest = 0;
    for (int k = 1; k < static_cast<int>(ride.duration_s() / kDt); ++k) {
      const double time = k * kDt;
      const double before = ride.HeightAt(time - kDt);
      const double here = ride.HeightAt(time);
      const double after = ride.HeightAt(time + kDt);
      fastest = std::max(fastest, std::abs(after - before) / (2.0 * kDt));
      hardest = std::max(hardest, std::abs(after - 2.0 * here + before) / (kDt * kDt));
    }
    EXPECT_LE(fastest, settings.lift_speed_mps + 1e-6) << rise_m;
    EXPECT_NEAR(hardest, settings.lift_acceleration_mps2, 0.01) << rise_m;
  }
}

TEST(Route, HasTheHeightsOfItsCornersAndRoundsTheirEdges) {
  Random random(1);
  const Route route({{{0, 0}, 0.0, WayKind::kCorridor},
                     {{5, 0}, 0.0, WayKind::kCorridor},
                     {{11, 0}, 3.0, WayKind::kStairs},
                     {{16, 0}, 3.0, WayKind::kCorridor}},
                    {}, &random);
  EXPECT_NEAR(route.length_m(), 16.0, 1e-9);
  EXPECT_EQ(route.HeightAt(0), 0.0);
  EXPECT_NEAR(route.HeightAt(8), 1.5, 1e-9);
  EXPECT_NEAR(route.HeightAt(16), 3.0, 1e-9);
  EXPECT_EQ(route.KindAt(4.9), WayKind::kCorridor);
  EXPECT_EQ(route.KindAt(5.1), WayKind::kStairs);
  EXPECT_EQ(route.KindAt(11.5), WayKind::kCorridor);
  double steepest = 0;
  for (int k = 0; k < 1600; ++k) {
    const double d = 0.01 * k;
    steepest = std::max(steepest, (route.HeightAt(d + 0.01) - route.HeightAt(d)) / 0.01);
  }
  EXPECT_NEAR(steepest, 0.5, 1e-6);
}

TEST(WalkLegs, ClimbsOneStairPerStep) {
  const SimulationSettings settings = CleanSettings();
  Random random(2);
  const double run_m = 40 * settings.gait.tread_m;
  const std::vector<Leg> legs = {{.route = Route({{{0, 0}, 0.0, WayKind::kCorridor},
                                                  {{8, 0}, 0.0, WayKind::kCorridor},
                                                  {{8 + run_m, 0}, 6.8, WayKind::kStairs},
                                                  {{16 + run_m, 0}, 6.8, WayKind::kCorridor}},
                                                 {}, &random)}};
  const Gait gait = RandomGait(settings.gait, &random);
  const std::vector<WalkState> states =
      WalkLegs(legs, gait, settings, kStandAtEndsS, 0, kIntervalNs, &random);
  double foot = 0;
  double top = 0;
  for (const WalkState& state : states) {
    if (state.distance_m <= 9.0) foot = state.step_phase;
    if (state.distance_m <= 7.0 + run_m) top = state.step_phase;
  }
  EXPECT_NEAR(top - foot, 40.0 - 2.0 / settings.gait.tread_m, 2.0);
  EXPECT_NEAR(states.back().height_m, 6.8, 1e-9);
}

// The specific force of a clean phone in a lift, turned to the vertical and integrated twice, is
// the change of height.
TEST(Simulation, VerticalAccelerationIntegratesToTheHeight) {
  SimulationSettings settings = CleanWalks();
  settings.inertial.acceleration_noise_mps2 = 0;
  settings.hold.sway_rad = 0;
  const Simulation simulation(settings, 5);
  int rides = 0;
  for (int index = 0; index < simulation.walk_count(); ++index) {
    const SimulatedWalk walk = simulation.MakeWalk(index);
    // A ride, from standstill to standstill.
    for (std::size_t i = 1; i < walk.path.size(); ++i) {
      if (walk.path[i].activity != Activity::kLift ||
          walk.path[i - 1].activity == Activity::kLift) {
        continue;
      }
      const std::size_t begin = i - 100;  // a second of standing before, and one after
      double speed = 0;
      double height = 0;
      std::size_t k = begin;
      while (k < walk.path.size() &&
             (k < i || walk.path[k - std::min<std::size_t>(k, 100)].activity == Activity::kLift)) {
        const Eigen::Vector3d force = walk.recording.accelerometer_mps2.value[k];
        const std::size_t slow = std::min(k / 2, walk.recording.rotation_vector.size() - 1);
        speed += ((walk.recording.rotation_vector.value[slow] * force).z() - 9.80665) * 0.01;
        height += speed * 0.01;
        ++k;
      }
      EXPECT_NEAR(height, walk.path[k].height_m - walk.path[begin].height_m, 0.05) << walk.name;
      EXPECT_NEAR(speed, 0.0, 0.02) << walk.name;
      ++rides;
    }
  }
  EXPECT_GE(rides, 3);
}

TEST(Simulation, GyroscopeIntegratesToTheTrueHeading) {
  SimulationSettings settings = CleanWalks();
  settings.inertial.gyro_noise_radps = 0;
  const Simulation simulation(settings, 6);
  for (int index = 0; index < simulation.walk_count(); ++index) {
    const SimulatedWalk walk = simulation.MakeWalk(index);
    double yaw = 0;
    double worst = 0;
    for (std::size_t i = 0; i < walk.path.size(); ++i) {
      const std::size_t slow = std::min(i / 2, walk.recording.rotation_vector.size() - 1);
      yaw += (walk.recording.rotation_vector.value[slow] * walk.recording.gyroscope_radps.value[i])
                 .z() *
             0.01;
      worst = std::max(worst,
                       std::abs(yaw - (walk.path[i].heading_rad - walk.path.front().heading_rad)));
    }
    // The sway of the hand (2 deg) and the coarse rotation vector remain.
    EXPECT_LT(worst, 0.08) << walk.name;
  }
}

TEST(Simulation, PeopleDoNotStepInLiftsAndOnEscalators) {
  const Simulation simulation(CleanWalks(), 7);
  int rides = 0;
  for (int index = 0; index < simulation.walk_count(); ++index) {
    const SimulatedWalk walk = simulation.MakeWalk(index);
    for (std::size_t i = 1; i < walk.path.size(); ++i) {
      const WalkState& state = walk.path[i];
      const WalkState& before = walk.path[i - 1];
      if (state.activity == Activity::kLift && before.activity == Activity::kLift) {
        ASSERT_EQ(state.step_phase, before.step_phase);
        ++rides;
      }
      if (state.activity == Activity::kEscalator && before.activity == Activity::kEscalator) {
        ASSERT_EQ(state.step_phase, before.step_phase);
        ++rides;
      }
    }
  }
  EXPECT_GT(rides, 1000);
}

TEST(Simulation, PathsAreContinuousAndHumanlyPossible) {
  for (const char* scenario : {"office", "hall"}) {
    SimulationSettings settings = *ScenarioSettings(scenario);
    settings.walks.connector_share = 0.6;
    const Simulation simulation(settings, 8);
    for (int index = 0; index < 8; ++index) {
      const SimulatedWalk walk = simulation.MakeWalk(index);
      for (std::size_t i = 1; i + 1 < walk.path.size(); ++i) {
        const Eigen::Vector2d a = walk.path[i - 1].position_m;
        const Eigen::Vector2d b = walk.path[i].position_m;
        const Eigen::Vector2d c = walk.path[i + 1].position_m;
        ASSERT_LT((b - a).norm() / 0.01, 2.2) << walk.name << " " << i;
        ASSERT_LT((a - 2.0 * b + c).norm() / 1e-4, 6.0) << walk.name << " " << i;
        ASSERT_LT(std::abs(walk.path[i].heading_rad - walk.path[i - 1].heading_rad) / 0.01, 6.0);
        const double climb = walk.path[i].height_m - walk.path[i - 1].height_m;
        ASSERT_LT(std::abs(climb) / 0.01, 1.05) << walk.name << " " << i;
      }
    }
  }
}

}  // namespace
}  // namespace walkgraph
