#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "data/dataset.h"
#include "data/formats/csv.h"
#include "data/input_error.h"
#include "data/simulator/scenarios.h"
#include "data/simulator/write_simulation.h"
#include "data/temporary_folder.h"

namespace walkgraph {
namespace {

SimulationSettings ShortWalks() {
  SimulationSettings settings;
  settings.walks.survey = 2;
  settings.walks.test = 1;
  settings.walks.duration_s = 60;
  settings.walks.handling_s = 5;
  settings.building.rotation_deg = 20.7;
  return settings;
}

// What a format keeps of each number.
struct Tolerances {
  double sensor = 1e-6;
  double rotation = 1e-5;  // w follows from a norm: near half turns digits are lost
  double pressure_hpa = 1e-6;
  double waypoint_m = 1e-3;
  bool short_beacon_names = false;  // the address alone
};

template <typename T, typename Distance>
void ExpectClose(const Stream<T>& read, const Stream<T>& made, double tolerance,
                 const Distance& distance) {
  ASSERT_EQ(read.time_ns, made.time_ns);
  for (std::size_t i = 0; i < read.size(); ++i) {
    ASSERT_LE(distance(read.value[i], made.value[i]), tolerance) << i;
  }
}

void ExpectSameRows(const Recording& read, const Recording& made, const Tolerances& tolerances) {
  ASSERT_EQ(read.radio_rows.size(), made.radio_rows.size());
  EXPECT_EQ(read.transmitters.size(), made.transmitters.size());
  for (std::size_t i = 0; i < read.radio_rows.size(); ++i) {
    const RadioRow& a = read.radio_rows[i];
    const RadioRow& b = made.radio_rows[i];
    std::string name = made.transmitters[b.transmitter].name;
    if (tolerances.short_beacon_names) name = name.substr(name.rfind('_') + 1);
    ASSERT_EQ(read.transmitters[a.transmitter].name, name) << i;
    ASSERT_EQ(read.transmitters[a.transmitter].radio, made.transmitters[b.transmitter].radio) << i;
    ASSERT_EQ(a.rssi_dbm, b.rssi_dbm);
    ASSERT_EQ(a.printed_ns, b.printed_ns);
    // GetSensorData knows no time of hearing for beacons: theirs is that of the row.
    ASSERT_EQ(a.heard_ns, b.heard_ns);
  }
}

void ExpectSameWalk(const Walk& read, const SimulatedWalk& made, const Building& building,
                    const Tolerances& tolerances) {
  const auto vectors = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a - b).cwiseAbs().maxCoeff();
  };
  const auto numbers = [](double a, double b) { return std::abs(a - b); };
  const auto turns = [](const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
    return a.angularDistance(b);
  };
  EXPECT_TRUE(read.report.hazards.empty());
  EXPECT_EQ(read.recording.device, made.recording.device);
  const Recording& a = read.recording;
  const Recording& b = made.recording;
  ExpectClose(a.accelerometer_mps2, b.accelerometer_mps2, tolerances.sensor, vectors);
  ExpectClose(a.gyroscope_radps, b.gyroscope_radps, tolerances.sensor, vectors);
  ExpectClose(a.magnetometer_ut, b.magnetometer_ut, tolerances.sensor, vectors);
  ExpectClose(a.rotation_vector, b.rotation_vector, tolerances.rotation, turns);
  ExpectClose(a.pressure_hpa, b.pressure_hpa, tolerances.pressure_hpa, numbers);
  ExpectSameRows(a, b, tolerances);
  const Truth truth = ToBuildingFrame(read.truth, building);
  ASSERT_EQ(truth.waypoints.size(), made.truth.waypoints.size());
  for (std::size_t i = 0; i < truth.waypoints.size(); ++i) {
    EXPECT_EQ(truth.waypoints[i].time_ns, made.truth.waypoints[i].time_ns);
    EXPECT_EQ(truth.waypoints[i].floor, made.truth.waypoints[i].floor);
    EXPECT_LT((truth.waypoints[i].position - made.truth.waypoints[i].position).norm(),
              tolerances.waypoint_m);
  }
}

// Writes a simulation and reads both data sets back, walk by walk.
void ExpectRoundTrip(const SimulationSettings& settings, SimulationFormat format,
                     const Tolerances& tolerances) {
  const Simulation simulation(settings, 3);
  const TemporaryFolder folder;
  WriteSimulation(simulation, format, folder.Path());
  int index = 0;
  for (const char* set : {"survey", "test"}) {
    const Dataset dataset = OpenDataset(folder.Path(set));
    EXPECT_TRUE(dataset.unrecognised.empty());
    ASSERT_EQ(dataset.building.floors.size(), simulation.plan().building.floors.size());
    EXPECT_EQ(dataset.building.floors.back().height_m,
              simulation.plan().building.floors.back().height_m);
    const int walks = std::string(set) == "survey" ? settings.walks.survey : settings.walks.test;
    ASSERT_EQ(dataset.walks.size(), static_cast<std::size_t>(walks));
    for (int i = 0; i < walks; ++i, ++index) {
      const SimulatedWalk made = simulation.MakeWalk(index);
      const std::string stem = made.name.substr(made.name.find('/') + 1);
      const auto file =
          std::find_if(dataset.walks.begin(), dataset.walks.end(),
                       [&stem](const WalkFile& walk) { return walk.id.ends_with(stem); });
      ASSERT_NE(file, dataset.walks.end()) << made.name;
      ExpectSameWalk(ReadWalk(*file), made, dataset.building, tolerances);
    }
  }
}

TEST(SimulationFormats, CsvGivesBackTheWalks) {
  ExpectRoundTrip(ShortWalks(), SimulationFormat::kCsv,
                  {.sensor = 6e-3, .rotation = 1e-4, .pressure_hpa = 6e-5});
}

TEST(SimulationFormats, Ilc20GivesBackTheWalks) {
  SimulationSettings settings = ShortWalks();
  settings.walks.change_floors = false;
  settings.building.lowest_floor = -1;
  ExpectRoundTrip(settings, SimulationFormat::kIlc20, {.rotation = 2e-4});
}

TEST(SimulationFormats, GetSensorDataGivesBackTheWalks) {
  ExpectRoundTrip(ShortWalks(), SimulationFormat::kGetSensorData,
                  {.rotation = 2e-4, .short_beacon_names = true});
}

// The site that ilc20 describes by itself is the same, but for the heights that it does not know.
TEST(SimulationFormats, Ilc20SitesHaveTheOutlinesOfTheBuilding) {
  SimulationSettings settings = ShortWalks();
  settings.walks.change_floors = false;
  const Simulation simulation(settings, 3);
  const TemporaryFolder folder;
  WriteSimulation(simulation, SimulationFormat::kIlc20, folder.Path());
  std::filesystem::remove(folder.Path("survey/building.json"));
  const Dataset dataset = OpenDataset(folder.Path("survey"));
  ASSERT_EQ(dataset.building.floors.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const Floor& read = dataset.building.floors[i];
    const Floor& made = simulation.plan().building.floors[i];
    EXPECT_EQ(read.number, made.number);
    ASSERT_EQ(read.obstacles.size(), made.obstacles.size());
    for (std::size_t k = 0; k < made.obstacles.size(); ++k) {
      for (std::size_t v = 0; v < made.obstacles[k].size(); ++v) {
        EXPECT_LT((read.obstacles[k][v] - made.obstacles[k][v]).norm(), 1e-3);
      }
    }
  }
}

TEST(SimulationFormats, Ilc20RefusesWalksOverSeveralFloors) {
  SimulationSettings settings = ShortWalks();
  settings.walks.connector_share = 1.0;
  const TemporaryFolder folder;
  EXPECT_THROW(WriteSimulation(Simulation(settings, 3), SimulationFormat::kIlc20, folder.Path()),
               InputError);
}

TEST(SimulationFormats, ExactPathsAreWrittenBesideTheWalks) {
  const Simulation simulation(ShortWalks(), 4);
  const TemporaryFolder folder;
  WriteSimulation(simulation, SimulationFormat::kCsv, folder.Path());
  const SimulatedWalk walk = simulation.MakeWalk(0);
  const std::vector<PathPoint> path = ReadPathCsv(folder.Path(walk.name + "/path.csv"));
  EXPECT_EQ(path.front().time_ns, walk.path.front().time_ns);
  EXPECT_EQ(path.back().time_ns, walk.path.back().time_ns);
  std::size_t state = 0;
  for (const PathPoint& point : path) {
    while (walk.path[state].time_ns < point.time_ns) ++state;
    ASSERT_EQ(walk.path[state].time_ns, point.time_ns);
    EXPECT_LT((point.position_m.head<2>() - walk.path[state].position_m).norm(), 1e-3);
    EXPECT_NEAR(point.position_m.z(), walk.path[state].height_m, 1e-3);
    EXPECT_NEAR(point.heading_rad, walk.path[state].heading_rad, 1e-3);
  }
}

}  // namespace
}  // namespace walkgraph
