#include "data/simulator/simulation.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "data/angle.h"
#include "data/formats/csv.h"
#include "data/input_error.h"
#include "data/simulator/itinerary.h"
#include "data/simulator/scenarios.h"
#include "data/temporary_folder.h"

namespace walkgraph {
namespace {

SimulationSettings Short(SimulationSettings settings) {
  settings.walks.duration_s = 90;
  settings.walks.handling_s = 0;
  return settings;
}

bool SameStreams(const Stream<Eigen::Vector3d>& a, const Stream<Eigen::Vector3d>& b) {
  return a.time_ns == b.time_ns && a.value == b.value;
}

bool SameRadio(const Recording& a, const Recording& b) {
  if (a.transmitters != b.transmitters || a.radio_rows.size() != b.radio_rows.size()) return false;
  for (std::size_t i = 0; i < a.radio_rows.size(); ++i) {
    if (a.radio_rows[i].printed_ns != b.radio_rows[i].printed_ns ||
        a.radio_rows[i].heard_ns != b.radio_rows[i].heard_ns ||
        a.radio_rows[i].transmitter != b.radio_rows[i].transmitter ||
        a.radio_rows[i].rssi_dbm != b.radio_rows[i].rssi_dbm) {
      return false;
    }
  }
  return true;
}

// Mean rotation-vector heading minus walking heading over a walk, rad.
double HeadingError(const SimulatedWalk& walk) {
  double sum = 0;
  for (std::size_t i = 0; i < walk.recording.rotation_vector.size(); ++i) {
    const Eigen::Vector3d forward =
        walk.recording.rotation_vector.value[i] * Eigen::Vector3d::UnitY();
    sum += WrapAngle(std::atan2(forward.y(), forward.x()) - walk.path[2 * i].heading_rad);
  }
  return sum / static_cast<double>(walk.recording.rotation_vector.size());
}

TEST(Simulation, AWalkHangsOnNothingButSettingsSeedAndNumber) {
  const SimulationSettings settings = Short({});
  const Simulation one(settings, 11);
  const Simulation two(settings, 11);
  one.MakeWalk(0);
  const SimulatedWalk a = one.MakeWalk(3);
  const SimulatedWalk b = two.MakeWalk(3);
  EXPECT_TRUE(SameStreams(a.recording.accelerometer_mps2, b.recording.accelerometer_mps2));
  EXPECT_TRUE(SameStreams(a.recording.magnetometer_ut, b.recording.magnetometer_ut));
  EXPECT_EQ(a.recording.pressure_hpa.value, b.recording.pressure_hpa.value);
  EXPECT_TRUE(SameRadio(a.recording, b.recording));
  const SimulatedWalk other = Simulation(settings, 12).MakeWalk(3);
  EXPECT_FALSE(SameRadio(a.recording, other.recording));
}

// Each scenario changes the streams that its disturbance reaches, and no other by a single bit.
TEST(Simulation, ScenariosToggleOneDisturbanceEach) {
  const SimulatedWalk clean = Simulation(Short(CleanSettings()), 13).MakeWalk(41);
  struct Expectation {
    const char* scenario;
    bool acceleration, gyroscope, magnetic, pressure, radio;  // whether it stays the same
  };
  for (const Expectation& expected :
       {Expectation{"gyro_bias", true, false, true, true, true},
        Expectation{"heading_offset", false, false, false, true, true},
        Expectation{"step_scale", false, true, true, true, true},
        Expectation{"baro_offset", true, true, true, false, true},
        Expectation{"map_change", true, true, true, true, false}}) {
    const SimulationSettings settings = Short(*ScenarioSettings(expected.scenario));
    const SimulatedWalk walk = Simulation(settings, 13).MakeWalk(41);
    EXPECT_EQ(walk.path.back().position_m, clean.path.back().position_m) << expected.scenario;
    const Recording& a = walk.recording;
    const Recording& b = clean.recording;
    EXPECT_EQ(SameStreams(a.accelerometer_mps2, b.accelerometer_mps2), expected.acceleration)
        << expected.scenario;
    EXPECT_EQ(SameStreams(a.gyroscope_radps, b.gyroscope_radps), expected.gyroscope)
        << expected.scenario;
    EXPECT_EQ(SameStreams(a.magnetometer_ut, b.magnetometer_ut), expected.magnetic)
        << expected.scenario;
    EXPECT_EQ(a.pressure_hpa.value == b.pressure_hpa.value, expected.pressure) << expected.scenario;
    EXPECT_EQ(SameRadio(a, b), expected.radio) << expected.scenario;
  }
}

TEST(Simulation, TheMapOfSurveyWalksDoesNotChange) {
  const SimulatedWalk clean = Simulation(Short(CleanSettings()), 14).MakeWalk(2);
  const SimulatedWalk changed = Simulation(Short(*ScenarioSettings("map_change")), 14).MakeWalk(2);
  EXPECT_TRUE(SameRadio(clean.recording, changed.recording));
}

TEST(Simulation, HeadingsAreTrueWhereNothingIsWrong) {
  SimulationSettings settings = Short(CleanSettings());
  settings.building.rotation_deg = 0;
  EXPECT_NEAR(HeadingError(Simulation(settings, 15).MakeWalk(0)), 0.0, 0.01);
  // A frame that is turned by 30 degrees from east is seen by a phone that knows north alone.
  settings.building.rotation_deg = 30;
  EXPECT_NEAR(HeadingError(Simulation(settings, 15).MakeWalk(0)), DegreesToRadians(30.0), 0.01);
}

TEST(Simulation, MagneticFieldDisturbsTheNormAsRecordedWalksShow) {
  const Simulation simulation(Short({}), 16);
  double sum = 0;
  for (int index = 0; index < 10; ++index) {
    double mean = 0;
    double squares = 0;
    const auto& field = simulation.MakeWalk(index).recording.magnetometer_ut.value;
    for (const Eigen::Vector3d& sample : field) {
      mean += sample.norm() / static_cast<double>(field.size());
      squares += sample.squaredNorm() / static_cast<double>(field.size());
    }
    sum += std::sqrt(squares - mean * mean) / 10.0;
  }
  EXPECT_NEAR(sum, 4.2, 1.0);  // uT: ilc20 4.2, ipin2023 4.3
}

TEST(Simulation, WalksStayWherePeopleCanWalk) {
  for (const char* scenario : {"office", "hall"}) {
    const Simulation simulation(Short(*ScenarioSettings(scenario)), 17);
    for (int index = 0; index < 6; ++index) {
      const SimulatedWalk walk = simulation.MakeWalk(index);
      for (const WalkState& state : walk.path) {
        const Floor* floor =
            simulation.plan().building.FindFloor(simulation.plan().FloorAt(state.height_m));
        ASSERT_TRUE(InsidePolygons(floor->outline, state.position_m)) << walk.name;
        ASSERT_FALSE(InsidePolygons(floor->obstacles, state.position_m)) << walk.name;
      }
    }
  }
}

// Height moves only near the line through a connector's stops: what building.json promises.
TEST(Simulation, HeightMovesAtConnectorsAlone) {
  SimulationSettings settings = Short({});
  settings.walks.connector_share = 0.7;
  const Simulation simulation(settings, 18);
  const Building& building = simulation.plan().building;
  ASSERT_EQ(building.connectors.size(), 5U);  // two escalators, two stairwells, a lift
  std::set<Activity> seen;
  for (int index = 0; index < 12; ++index) {
    for (const WalkState& state : simulation.MakeWalk(index).path) {
      const double level = simulation.plan().HeightOf(simulation.plan().FloorAt(state.height_m));
      if (std::abs(state.height_m - level) < 0.1) continue;
      seen.insert(state.activity);
      bool near = false;
      for (const Connector& connector : building.connectors) {
        const Eigen::Vector2d begin = connector.stops.front().position;
        const Eigen::Vector2d along = connector.stops.back().position - begin;
        const double share =
            along.isZero()
                ? 0.0
                : std::clamp((state.position_m - begin).dot(along) / along.squaredNorm(), 0.0, 1.0);
        near |= (begin + share * along - state.position_m).norm() <= connector.radius_m;
      }
      ASSERT_TRUE(near) << state.position_m.transpose();
    }
  }
  EXPECT_TRUE(seen.contains(Activity::kStairs));
  EXPECT_TRUE(seen.contains(Activity::kLift));
  EXPECT_TRUE(seen.contains(Activity::kEscalator));
}

TEST(Simulation, WaypointsLieOnTheExactPathAndOnLevels) {
  const Simulation simulation(Short({}), 19);
  for (int index = 0; index < 6; ++index) {
    const SimulatedWalk walk = simulation.MakeWalk(index);
    ASSERT_GE(walk.truth.waypoints.size(), 5U);
    TimeNs last_ns = walk.truth.waypoints.front().time_ns;
    std::size_t state = 0;
    for (const Waypoint& waypoint : walk.truth.waypoints) {
      while (walk.path[state].time_ns < waypoint.time_ns) ++state;
      EXPECT_EQ(walk.path[state].position_m, waypoint.position);
      EXPECT_NEAR(walk.path[state].height_m, simulation.plan().HeightOf(waypoint.floor), 0.05);
      EXPECT_LT(SecondsBetween(last_ns, waypoint.time_ns),
                40.0);  // a ride lies between the longest
      last_ns = waypoint.time_ns;
    }
    const double duration_s = SecondsBetween(walk.path.front().time_ns, walk.path.back().time_ns);
    EXPECT_NEAR(duration_s, 90.0, 45.0) << walk.name;
  }
}

TEST(Simulation, WalksInAGivenBuilding) {
  const TemporaryFolder folder;
  Building building;
  for (int number = 0; number < 2; ++number) {
    Floor floor;
    floor.number = number;
    floor.name = std::to_string(number);
    floor.height_m = 4.0 * number;
    floor.max_corner = {30, 12};
    floor.outline = {{{0, 0}, {30, 0}, {30, 12}, {0, 12}}};
    floor.obstacles = {{{10, 0}, {20, 0}, {20, 8}, {10, 8}}};
    building.floors.push_back(floor);
  }
  building.connectors = {{"lift", ConnectorKind::kLift, {{0, {3, 6}}, {1, {3, 6}}}, 2.0},
                         {"ramp", ConnectorKind::kStairs, {{0, {22, 3}}, {1, {28, 3}}}, 2.0}};
  const std::string path = folder.Path("building.json");
  WriteBuildingJson(building, path);
  SimulationSettings settings = Short({});
  settings.building.kind = BuildingKind::kGiven;
  settings.building.grid_spacing_m = 2.0;
  const Simulation simulation(settings, 20, path);
  std::set<int> floors;
  for (int index = 0; index < 4; ++index) {
    const SimulatedWalk walk = simulation.MakeWalk(index);
    for (const WalkState& state : walk.path) {
      ASSERT_FALSE(InsidePolygons(building.floors[0].obstacles, state.position_m));
    }
    for (const Waypoint& waypoint : walk.truth.waypoints) floors.insert(waypoint.floor);
  }
  EXPECT_EQ(floors.size(), 2U);

  building.connectors[0].stops[1].floor = 7;
  WriteBuildingJson(building, path);
  EXPECT_THROW(Simulation(settings, 20, path), InputError);
}

TEST(Simulation, AnHourLongWalkGoesThroughTheWholeHouse) {
  SimulationSettings settings;
  settings.walks.duration_s = 3600;
  settings.wifi.enabled = false;
  settings.beacon.enabled = false;
  const Simulation simulation(settings, 21);
  const SimulatedWalk walk = simulation.MakeWalk(0);
  EXPECT_NEAR(SecondsBetween(walk.path.front().time_ns, walk.path.back().time_ns), 3600.0, 300.0);
  std::set<Activity> seen;
  for (const WalkState& state : walk.path) seen.insert(state.activity);
  EXPECT_EQ(seen.size(), 5U);
}

}  // namespace
}  // namespace walkgraph
