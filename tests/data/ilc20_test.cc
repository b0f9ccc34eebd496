#include "data/formats/ilc20.h"

#include <gtest/gtest.h>

#include <string>

#include "data/input_error.h"
#include "data/temporary_folder.h"

namespace walkgraph {
namespace {

constexpr char kHeader[] =
    "#\tstartTime:1574559495255\n#\tBrand:OPPO\tModel:PBCM10\tAndroidName:8.1.0\n";

Walk ReadBody(const std::string& body) { return ReadIlc20(kHeader + body, 0); }

TEST(Ilc20, ReadsEveryUsedRecord) {
  const Walk walk = ReadBody(
      "1000\tTYPE_WAYPOINT\t81.5\t93.25\n"
      "1100\tTYPE_ACCELEROMETER\t-0.5\t1.5\t9.75\t2\n"
      "1100\tTYPE_GYROSCOPE\t0.1\t0.2\t0.3\t3\n"
      "1100\tTYPE_MAGNETIC_FIELD\t29.5\t6.5\t-30\t3\n"
      "1100\tTYPE_ROTATION_VECTOR\t0\t0\t0.6\t3\n"
      "2000\tTYPE_WIFI\tFMI\tA8:0C:ca:03:9d:d7\t-49\t2422\t1450\n"
      "2100\tTYPE_BEACON\tAB-1\t7\t9\t-56\t-93\t45.03\tE0:78:A3:3D:B5:D6\t2100\n");
  const Recording& recording = walk.recording;
  EXPECT_EQ(recording.device, "PBCM10");
  EXPECT_EQ(recording.accelerometer_mps2.value.at(0), Eigen::Vector3d(-0.5, 1.5, 9.75));
  EXPECT_EQ(recording.gyroscope_radps.value.at(0), Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(recording.magnetometer_ut.value.at(0), Eigen::Vector3d(29.5, 6.5, -30));
  EXPECT_NEAR(recording.rotation_vector.value.at(0).w(), 0.8, 1e-12);
  ASSERT_EQ(recording.radio_rows.size(), 2U);
  EXPECT_EQ(recording.radio_rows[0].heard_ns, 1450 * kNsPerMs);
  EXPECT_EQ(recording.radio_rows[0].printed_ns, 2000 * kNsPerMs);
  EXPECT_EQ(recording.transmitters[0].name, "a8:0c:ca:03:9d:d7");
  EXPECT_EQ(recording.transmitters[1].name, "ab-1_7_9_e0:78:a3:3d:b5:d6");
  EXPECT_EQ(recording.transmitters[1].radio, Radio::kBeacon);
  EXPECT_EQ(recording.begin_ns, 1100 * kNsPerMs);  // a waypoint is truth, not a sensor
  EXPECT_EQ(recording.end_ns, 2100 * kNsPerMs);
  EXPECT_EQ(walk.truth.waypoints.at(0).position, Eigen::Vector2d(81.5, 93.25));
  EXPECT_TRUE(walk.report.hazards.empty());
}

TEST(Ilc20, CountsEveryHazardByName) {
  const Walk walk = ReadBody(
      "1000\tTYPE_ACCELEROMETER\t0\t0\t9.8\t2\n"
      "1020\tTYPE_ACCELEROMETER\tnan\t0\t9.8\t2\n"
      "1040\tTYPE_ACCELEROMETER\t1e5\t0\t9.8\t2\n"
      "1060\tTYPE_ACCELEROMETER\t0\t0\n"
      "1000\tTYPE_ACCELEROMETER\t1\t0\t9.8\t2\n"
      "garbage\n"
      "2000\tTYPE_WIFI\tx\ta8:0c:ca:03:9d:d7\t-49\t2422\t2500\n"
      "2000\tTYPE_WIFI\tx\ta8:0c:ca:03:9d:d7\t127\t2422\t2000\n"
      "2000\tTYPE_WIFI\tx\ty\tz\ta8:0c:ca:03:9d:d8\t-50\t2422\t0\n"
      "2000\tTYPE_NEW_SENSOR\t1\n"
      "9000000000\tTYPE_ACCELEROMETER\t0\t0\t9.8\t2\n"
      "1080\tTYPE_ACCELEROMETER\t0\t0\t9");
  EXPECT_EQ(walk.report.HazardCount("non_finite"), 1);
  EXPECT_EQ(walk.report.HazardCount("out_of_range"), 2);  // acceleration and RSSI
  EXPECT_EQ(walk.report.HazardCount("malformed"), 2);
  EXPECT_EQ(walk.report.first_malformed_line, 6);
  EXPECT_EQ(walk.report.HazardCount("duplicate_time"), 1);
  EXPECT_EQ(walk.report.HazardCount("heard_after_printed"), 1);
  EXPECT_EQ(walk.report.HazardCount("separator_in_ssid"), 1);
  EXPECT_EQ(walk.report.HazardCount("stray_time"), 1);
  EXPECT_TRUE(walk.report.cut_last_line);
  EXPECT_EQ(walk.report.records.at("TYPE_NEW_SENSOR"), 1);
  EXPECT_EQ(walk.recording.accelerometer_mps2.size(), 1U);
  EXPECT_EQ(walk.recording.radio_rows.size(), 2U);
  EXPECT_LE(walk.recording.radio_rows[0].heard_ns, walk.recording.radio_rows[0].printed_ns);
}

TEST(Ilc20, AcceptsWindowsLineEndsAndOddBytesInNames) {
  const Walk walk = ReadBody(
      "2000\tTYPE_WIFI\t\xff\xfe \x01\ta8:0c:ca:03:9d:d7\t-49\t2422\t2000\r\n"
      "2000\tTYPE_WIFI\t\ta8:0c:ca:03:9d:d8\t-50\t2422\t2000\r\n");
  EXPECT_EQ(walk.recording.radio_rows.size(), 2U);
  EXPECT_TRUE(walk.report.hazards.empty());
}

TEST(Ilc20, SeesASensorWhoseClockIsSecondsOff) {
  std::string body;
  for (int i = 0; i < 500; ++i) {
    body += std::to_string(10000 + 20 * i) + "\tTYPE_ACCELEROMETER\t0\t0\t9.8\t2\n";
    body += std::to_string(13000 + 20 * i) + "\tTYPE_GYROSCOPE\t0\t0\t0\t2\n";
  }
  EXPECT_EQ(ReadBody(body).report.HazardCount("clock_disagreement"), 1);
}

TEST(Ilc20, FloorNamesGiveNumbers) {
  EXPECT_EQ(Ilc20FloorNumber("B2"), -2);
  EXPECT_EQ(Ilc20FloorNumber("F1"), 0);
  EXPECT_EQ(Ilc20FloorNumber("F10"), 9);
  EXPECT_EQ(Ilc20FloorNumber("3F"), 2);
  EXPECT_EQ(Ilc20FloorNumber("L1"), 0);
  for (const char* name : {"", "F", "F0", "floor", "path_data_files", "B1a", "F-3"}) {
    EXPECT_FALSE(Ilc20FloorNumber(name).has_value()) << name;
  }
}

TEST(Ilc20, MapsThePlanOntoItsRectangle) {
  const TemporaryFolder folder;
  folder.Write("F2/floor_info.json", R"({"map_info":{"height":20,"width":40}})");
  folder.Write("F2/geojson_map.json",
               R"({"features":[
      {"geometry":{"type":"MultiPolygon","coordinates":[[[[120,30],[120.4,30],[120.4,30.2],[120,30.2],[120,30]]]]}},
      {"geometry":{"type":"Polygon","coordinates":[[[120.1,30.05],[120.2,30.05],[120.2,30.1],[120.1,30.05]]]}},
      {"geometry":{"type":"Point","coordinates":[120.1,30.05]}}]})");
  const Floor floor = ReadIlc20Floor(folder.Path("F2"));
  EXPECT_EQ(floor.number, 1);
  EXPECT_EQ(floor.max_corner, Eigen::Vector2d(40, 20));
  ASSERT_EQ(floor.outline.size(), 1U);
  ASSERT_EQ(floor.outline[0].size(), 4U);
  EXPECT_TRUE(floor.outline[0][2].isApprox(Eigen::Vector2d(40, 20)));
  ASSERT_EQ(floor.obstacles.size(), 1U);
  EXPECT_TRUE(floor.obstacles[0][1].isApprox(Eigen::Vector2d(20, 5), 1e-9));
  EXPECT_TRUE(floor.image.path.empty());
}

TEST(Ilc20, SaysWhatIsWrongWithABrokenPlan) {
  const TemporaryFolder folder;
  folder.Write("F1/floor_info.json", R"({"map_info":{"height":20}})");
  EXPECT_THROW(ReadIlc20Floor(folder.Path("F1")), InputError);
  folder.Write("F1/floor_info.json", R"({"map_info":{"height":20,"width":0}})");
  EXPECT_THROW(ReadIlc20Floor(folder.Path("F1")), InputError);
  folder.Write("F1/floor_info.json", R"({"map_info":{"height":20,"width":40}})");
  folder.Write("F1/geojson_map.json", "{");
  EXPECT_THROW(ReadIlc20Floor(folder.Path("F1")), InputError);
  folder.Write("F1/geojson_map.json", R"({"features":[]})");
  EXPECT_THROW(ReadIlc20Floor(folder.Path("F1")), InputError);
}

}  // namespace
}  // namespace walkgraph
