#include "data/formats/csv.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "data/dataset.h"
#include "data/input_error.h"
#include "data/simulator/sample.h"
#include "data/temporary_folder.h"

namespace walkgraph {
namespace {

template <typename T, typename Distance>
void ExpectClose(const Stream<T>& actual, const Stream<T>& expected, double tolerance,
                 const Distance& distance) {
  ASSERT_EQ(actual.time_ns, expected.time_ns);
  for (std::size_t i = 0; i < actual.size(); ++i) {
    ASSERT_LT(distance(actual.value[i], expected.value[i]), tolerance);
  }
}

TEST(Csv, GivesBackWhatWasWritten) {
  SimulatedWalk walk = MakeSample(5).walks.front();
  walk.recording.transmitters.push_back({Radio::kBeacon, "uuid_1_2_aa:bb"});
  const auto beacon = static_cast<std::uint32_t>(walk.recording.transmitters.size() - 1);
  const TimeNs heard = walk.recording.begin_ns + 2 * kNsPerSecond;
  walk.recording.radio_rows.insert(walk.recording.radio_rows.begin(),
                                   {heard, heard, beacon, -71.0F});
  const TemporaryFolder folder;
  WriteCsvWalk(walk.recording, walk.truth, {}, folder.Path("walk"));
  const Walk read = ReadCsvWalk(folder.Path("walk"));
  EXPECT_TRUE(read.report.hazards.empty());
  EXPECT_EQ(read.recording.device, walk.recording.device);

  const auto norm = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a - b).cwiseAbs().maxCoeff();
  };
  const auto angle = [](const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
    return a.angularDistance(b);
  };
  const auto difference = [](double a, double b) { return std::abs(a - b); };
  ExpectClose(read.recording.accelerometer_mps2, walk.recording.accelerometer_mps2, 6e-4, norm);
  ExpectClose(read.recording.gyroscope_radps, walk.recording.gyroscope_radps, 6e-5, norm);
  ExpectClose(read.recording.magnetometer_ut, walk.recording.magnetometer_ut, 6e-3, norm);
  ExpectClose(read.recording.rotation_vector, walk.recording.rotation_vector, 4e-5, angle);
  ExpectClose(read.recording.pressure_hpa, walk.recording.pressure_hpa, 6e-5, difference);

  ASSERT_EQ(read.recording.radio_rows.size(), walk.recording.radio_rows.size());
  bool beacon_found = false;
  for (const RadioRow& row : read.recording.radio_rows) {
    const Transmitter& transmitter = read.recording.transmitters[row.transmitter];
    if (transmitter.radio != Radio::kBeacon) continue;
    beacon_found = true;
    EXPECT_EQ(transmitter.name, "uuid_1_2_aa:bb");
    EXPECT_EQ(row.rssi_dbm, -71.0F);
  }
  EXPECT_TRUE(beacon_found);
  ASSERT_EQ(read.truth.waypoints.size(), walk.truth.waypoints.size());
  for (std::size_t i = 0; i < read.truth.waypoints.size(); ++i) {
    EXPECT_TRUE(read.truth.waypoints[i].position.isApprox(walk.truth.waypoints[i].position, 1e-3));
  }
}

TEST(Csv, AWgs84TruthStaysWgs84) {
  Truth truth;
  truth.frame = TruthFrame::kWgs84;
  truth.waypoints = {{kNsPerSecond, {49.461221918, 11.111590101}, -2}};
  const TemporaryFolder folder;
  WriteCsvWalk({}, truth, {}, folder.Path("walk"));
  const Truth read = ReadCsvWalk(folder.Path("walk")).truth;
  EXPECT_EQ(read.frame, TruthFrame::kWgs84);
  ASSERT_EQ(read.waypoints.size(), 1U);
  EXPECT_EQ(read.waypoints[0].position, truth.waypoints[0].position);
  EXPECT_EQ(read.waypoints[0].floor, -2);
}

TEST(Csv, ReadsNanosecondsAndCountsBrokenRows) {
  const TemporaryFolder folder;
  folder.Write("walk/accelerometer.csv",
               "\xef\xbb\xbftime_ns,x_mps2,y_mps2,z_mps2\r\n"
               "1574559495260000001,0,0,9.8\r\n"
               "1574559495280000001,0,0,9.8,7\r\n"
               "1574559495300000001,0,0\r\n"
               "1574559495320000001,0,inf,9.8\r\n"
               "1574559495340000001,0,0,9.8\r\n"
               "1574559495360000001,0,0,9");
  const Walk walk = ReadCsvWalk(folder.Path("walk"));
  ASSERT_EQ(walk.recording.accelerometer_mps2.size(), 2U);
  EXPECT_EQ(walk.recording.begin_ns, 1574559495260000001);
  EXPECT_EQ(walk.report.HazardCount("malformed"), 2);
  EXPECT_EQ(walk.report.first_malformed_line, 3);
  EXPECT_EQ(walk.report.HazardCount("non_finite"), 1);
  EXPECT_TRUE(walk.report.cut_last_line);
  EXPECT_EQ(walk.report.records.at("accelerometer.csv"), 6);
}

TEST(Csv, AForeignHeaderIsAnErrorThatNamesTheExpectedOne) {
  const TemporaryFolder folder;
  for (const char* text : {"time_s,x,y,z\n1,0,0,9.8\n", ""}) {
    folder.Write("walk/accelerometer.csv", text);
    try {
      ReadCsvWalk(folder.Path("walk"));
      FAIL() << "no error";
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find("accelerometer.csv:1:"), std::string::npos) << what;
      EXPECT_NE(what.find("time_s,x_mps2,y_mps2,z_mps2"), std::string::npos) << what;
    }
  }
}

TEST(BuildingJson, GivesBackWhatWasWritten) {
  Building building = MakeSample(1).building;
  building.origin = GeoReference{49.46, 11.11, 0.36};
  const TemporaryFolder folder;
  building.floors[0].image = {folder.Path("plan.png"), {0, 0}, {44, 24}};
  WriteBuildingJson(building, folder.Path("building.json"));
  const Building read = ReadBuildingJson(folder.Path("building.json"));
  EXPECT_EQ(read.name, building.name);
  ASSERT_EQ(read.floors.size(), 1U);
  EXPECT_EQ(read.floors[0].outline, building.floors[0].outline);
  EXPECT_EQ(read.floors[0].obstacles, building.floors[0].obstacles);
  EXPECT_EQ(read.floors[0].image.path, folder.Path("plan.png"));
  EXPECT_EQ(read.floors[0].image.max_corner, Eigen::Vector2d(44, 24));
  ASSERT_TRUE(read.origin.has_value());
  EXPECT_NEAR(read.origin->rotation_rad, 0.36, 1e-12);
}

TEST(BuildingJson, KeepsTheWaysOfAFloor) {
  Building building;
  building.floors.resize(1);
  building.floors[0].max_corner = {9, 9};
  building.floors[0].ways = {{{1, 2}, {5, 2}, {5, 8}}, {{0, 1}, {1, 2}}};
  const TemporaryFolder folder;
  const std::string path = folder.Path("building.json");
  WriteBuildingJson(building, path);
  const WayNetwork read = ReadBuildingJson(path).floors[0].ways;
  EXPECT_EQ(read.nodes, building.floors[0].ways.nodes);
  EXPECT_EQ(read.links, building.floors[0].ways.links);
  folder.Write("building.json",
               R"({"floors":[{"number":0,"height_m":0,"min_corner":[0,0],"max_corner":[9,9],)"
               R"("ways":{"nodes":[[1,2],[5,2]],"links":[[0,2]]}}]})");
  EXPECT_THROW(ReadBuildingJson(path), InputError);
}

TEST(BuildingJson, KnowsWhereFloorsAreJoined) {
  Building building;
  building.floors.resize(2);
  building.floors[0].number = -1;
  building.floors[0].max_corner = building.floors[1].max_corner = {9, 9};
  building.connectors = {
      {"stairs", ConnectorKind::kStairs, {{-1, {1, 2}}, {0, {3, 4}}}, 2.5},
      {"lift", ConnectorKind::kLift, {{-1, {5, 6}}, {0, {5, 6}}}, 1.5},
      {"escalator", ConnectorKind::kEscalator, {{-1, {7, 1}}, {0, {1, 7}}}, 2.0}};
  const TemporaryFolder folder;
  const std::string path = folder.Path("building.json");
  WriteBuildingJson(building, path);
  const Building read = ReadBuildingJson(path);
  ASSERT_EQ(read.connectors.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.connectors[i].name, building.connectors[i].name);
    EXPECT_EQ(read.connectors[i].kind, building.connectors[i].kind);
    EXPECT_EQ(read.connectors[i].radius_m, building.connectors[i].radius_m);
    ASSERT_EQ(read.connectors[i].stops.size(), 2U);
    EXPECT_EQ(read.connectors[i].stops[1].floor, 0);
    EXPECT_EQ(read.connectors[i].stops[1].position, building.connectors[i].stops[1].position);
  }
  const std::string floors =
      R"({"floors":[{"number":0,"height_m":0,"min_corner":[0,0],"max_corner":[9,9]}],"connectors":)";
  folder.Write("building.json", floors + R"([{"kind":"ladder","stops":[]}]})");
  EXPECT_THROW(ReadBuildingJson(path), InputError);
  folder.Write("building.json",
               floors + R"([{"kind":"lift","stops":[{"floor":0,"position":[1,2]}]}]})");
  EXPECT_THROW(ReadBuildingJson(path), InputError);
}

TEST(BuildingJson, BoundsTheOutlineWhereNoCornersAreGiven) {
  const TemporaryFolder folder;
  folder.Write("building.json",
               R"({"floors":[{"number":2,"height_m":6,"outline":[[[1,2],[5,2],[5,9]]]},
                             {"number":1,"height_m":3,"min_corner":[0,0],"max_corner":[4,4]}]})");
  const Building building = ReadBuildingJson(folder.Path("building.json"));
  ASSERT_EQ(building.floors.size(), 2U);
  EXPECT_EQ(building.floors[0].number, 1);
  EXPECT_EQ(building.FindFloor(2)->min_corner, Eigen::Vector2d(1, 2));
  EXPECT_EQ(building.FindFloor(2)->max_corner, Eigen::Vector2d(5, 9));
  folder.Write("building.json", R"({"floors":[{"number":2,"height_m":6}]})");
  EXPECT_THROW(ReadBuildingJson(folder.Path("building.json")), InputError);
  folder.Write("building.json", "[]");
  EXPECT_THROW(ReadBuildingJson(folder.Path("building.json")), InputError);
}

}  // namespace
}  // namespace walkgraph
