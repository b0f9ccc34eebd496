#include "data/formats/getsensordata.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "data/input_error.h"
#include "data/simulator/random.h"
#include "data/temporary_folder.h"

namespace walkgraph {
namespace {

constexpr char kHeader[] =
    "% LogFile created by the 'GetSensorData' App for Android.\n"
    "% Model:                   \tSM-G930F\n";

Walk ReadBody(const std::string& body) { return ReadGetSensorData(kHeader + body); }

// The log was begun at 8:00:58 UTC, and its stamps count from then.
TEST(GetSensorData, DateOfCreationTellsUnixTime) {
  const std::string body = "PRES;2.5;9600.5;976.875;3\n";
  const Walk dated = ReadGetSensorData(
      std::string(kHeader) + "% Date of creation: Wed Jun 14 10:00:58 GMT+02:00 2023\n" + body);
  ASSERT_TRUE(dated.recording.begin_unix_ns.has_value());
  EXPECT_EQ(*dated.recording.begin_unix_ns, 1'686'729'658 * kNsPerSecond + DurationNs(2.5));
  EXPECT_FALSE(ReadBody(body).recording.begin_unix_ns.has_value());
}

TEST(GetSensorData, ReadsEveryUsedRecord) {
  const Walk walk = ReadBody(
      "ACCE;0.5;9600.5;-2.0;7.5;5.75;3\n"
      "GYRO;0.5;9600.5;-0.25;-0.5;0.125;3\n"
      "MAGN;0.5;9600.5;-10.5;-26.5;-4.75;3\n"
      "AHRS;0.5;9600.5;0;0;73.7;0;0;0.6;3\n"
      "PRES;0.5;9600.5;976.875;3\n"
      "WIFI;2.5;9602.25;SSID;20:23:00:00:00:AB;2417;-76\n"
      "BLE4;2.75;iBeacon;BE:AC:20:23:00:02;-96;0;1;2;1111\n"
      "GNSS;2.8;1686739901.9;49.4;11.1;380.2;171.7;4.0;0.4;18;8\n"
      "POSI;3.0;1;49.461221918752;11.111590101028;-2;100\n");
  const Recording& recording = walk.recording;
  EXPECT_EQ(recording.device, "SM-G930F");
  EXPECT_EQ(recording.accelerometer_mps2.time_ns.at(0), kNsPerSecond / 2);
  EXPECT_EQ(recording.accelerometer_mps2.value.at(0), Eigen::Vector3d(-2.0, 7.5, 5.75));
  EXPECT_EQ(recording.gyroscope_radps.value.at(0), Eigen::Vector3d(-0.25, -0.5, 0.125));
  EXPECT_EQ(recording.magnetometer_ut.value.at(0), Eigen::Vector3d(-10.5, -26.5, -4.75));
  EXPECT_NEAR(recording.rotation_vector.value.at(0).w(), 0.8, 1e-12);
  EXPECT_EQ(recording.pressure_hpa.value.at(0), 976.875);
  ASSERT_EQ(recording.radio_rows.size(), 2U);
  EXPECT_EQ(recording.transmitters[recording.radio_rows[0].transmitter].name, "20:23:00:00:00:ab");
  EXPECT_EQ(recording.radio_rows[0].heard_ns, DurationNs(2.25));
  EXPECT_EQ(recording.transmitters[recording.radio_rows[1].transmitter].name, "be:ac:20:23:00:02");
  EXPECT_EQ(walk.truth.frame, TruthFrame::kWgs84);
  EXPECT_EQ(walk.truth.waypoints.at(0).floor, -2);
  EXPECT_NEAR(walk.truth.waypoints.at(0).position.x(), 49.461221918752, 1e-12);
  EXPECT_EQ(walk.report.records.at("GNSS"), 1);
  EXPECT_TRUE(walk.report.hazards.empty());
}

TEST(GetSensorData, GivesJitteredSamplesTheSensorsIntervals) {
  Random random(3);
  std::string body;
  for (int i = 0; i < 500; ++i) {
    const double taken = 0.02 * i;
    char line[100];
    std::snprintf(line, sizeof(line), "GYRO;%.4f;%.4f;0;0;0;3\n",
                  taken + 0.004 + 0.03 * random.Uniform() * random.Uniform(), 500.0 + taken);
    body += line;
  }
  const auto& time_ns = ReadBody(body).recording.gyroscope_radps.time_ns;
  ASSERT_EQ(time_ns.size(), 500U);
  for (std::size_t i = 1; i < time_ns.size(); ++i) {
    ASSERT_EQ(time_ns[i] - time_ns[i - 1], 20 * kNsPerMs);
  }
  EXPECT_NEAR(static_cast<double>(time_ns[0]), 0.009e9, 0.003e9);  // the median delay
}

TEST(GetSensorData, KeepsTheApplicationsTimeWhereTheSensorsClockJumps) {
  std::string body;
  for (int i = 0; i < 200; ++i) {
    const double app = 0.02 * i;
    const double sensor = (i < 150 ? 100.0 : 7000.0) + app;
    char line[100];
    std::snprintf(line, sizeof(line), "ACCE;%.4f;%.4f;0;0;9.8;3\n", app, sensor);
    body += line;
  }
  const Walk walk = ReadBody(body);
  EXPECT_EQ(walk.report.HazardCount("sensor_clock_jump"), 50);
  EXPECT_EQ(walk.recording.accelerometer_mps2.size(), 200U);
  EXPECT_EQ(walk.recording.end_ns, DurationNs(0.02 * 199));
}

TEST(GetSensorData, SplitsWifiFromTheRight) {
  const Walk walk = ReadBody(
      "WIFI;2.5;9602.25;a;b;c;20:23:00:00:00:01;2417;-76\n"
      "WIFI;2.5;9602.25;;20:23:00:00:00:02;2417;-77;\n");
  ASSERT_EQ(walk.recording.radio_rows.size(), 2U);
  EXPECT_EQ(walk.recording.transmitters[0].name, "20:23:00:00:00:01");
  EXPECT_EQ(walk.recording.radio_rows[1].rssi_dbm, -77.0F);
  EXPECT_EQ(walk.recording.radio_rows[1].heard_ns, walk.recording.radio_rows[1].printed_ns);
  EXPECT_EQ(walk.report.HazardCount("separator_in_ssid"), 1);
}

TEST(GetSensorData, NamesTheTrial) {
  EXPECT_EQ(GetSensorDataTrial("logs__IPIN2023_T3_TrainingTrial51_repetition02"), "Trial51");
  EXPECT_EQ(GetSensorDataTrial("my_walk"), "my_walk");
  EXPECT_EQ(GetSensorDataTrial("TrialRun"), "TrialRun");
}

TEST(GetSensorData, IsRecognisedByHeaderOrRecord) {
  EXPECT_TRUE(LooksLikeGetSensorData(kHeader));
  EXPECT_TRUE(LooksLikeGetSensorData("%% Rebuilt\nGYRO;0.0411;73772.6419;-0.55;-0.14;-0.2;3\n"));
  EXPECT_FALSE(LooksLikeGetSensorData("1574559495260\tTYPE_DIST1\t19.3\n"));
  EXPECT_FALSE(LooksLikeGetSensorData("name;value\nabcd;1\n"));
}

TEST(FloorplansCal, BuildsTheFrameFromTheFirstImage) {
  const TemporaryFolder folder;
  folder.Write(
      "floorplans.cal",
      "% comment\nb.png a.png \n1 0 \n100 100 \n49.5 49.5 \n11.1 11.1 \n-30 -30 \n0.5 0.5 \n");
  // Only the size in a PNG's header matters: 100 columns by 60 rows.
  folder.Write("a.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x64\0\0\0\x3c", 24));
  const Building building = ReadFloorplansCal(folder.Path("floorplans.cal"));
  ASSERT_EQ(building.floors.size(), 2U);
  EXPECT_EQ(building.floors[0].number, 0);
  EXPECT_EQ(building.floors[0].image.max_corner, Eigen::Vector2d(25, 15));
  EXPECT_EQ(building.floors[1].max_corner, Eigen::Vector2d(25, 15));  // from the other floor
  EXPECT_TRUE(building.floors[1].image.path.empty());
  ASSERT_TRUE(building.origin.has_value());
  // East in a frame whose x axis points 30 degrees north of east.
  const Eigen::Vector2d east = Wgs84ToBuilding(49.5, 11.101, *building.origin);
  EXPECT_NEAR(std::atan2(east.y(), east.x()), -M_PI / 6, 1e-4);
}

TEST(FloorplansCal, RejectsTablesThatDoNotFit) {
  const TemporaryFolder folder;
  for (const char* text : {"", "a.png\n0\n", "a.png b.png\n0\n1\n49\n11\n0\n1\n",
                           "a.png\nx\n1\n49\n11\n0\n1\n", "a.png\n1e9\n1\n49\n11\n0\n1\n"}) {
    folder.Write("floorplans.cal", text);
    EXPECT_THROW(ReadFloorplansCal(folder.Path("floorplans.cal")), InputError) << text;
  }
}

}  // namespace
}  // namespace walkgraph
