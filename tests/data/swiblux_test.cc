#include "data/formats/swiblux.h"

#include <gtest/gtest.h>

#include <string>

#include "data/dataset.h"
#include "data/input_error.h"
#include "data/temporary_folder.h"

namespace walkgraph {
namespace {

constexpr char kLimits[] = "limits\n-1\n9\n0\n4\n";
constexpr char kWifi[] = "x;y;RSSI A;RSSI B\n1;2;-40;-92\n3;2;-92;-50.5\n5;2;-45;-55\n";
constexpr char kZigbee[] =
    "x;y;RSSI A;RSSI B\n1;2;-60;-61\n3;2.5;-62;-63\n5;2;-64;-65\n7;2;-66;-67\n";

class Swiblux : public testing::Test {
 protected:
  Swiblux() {
    folder_.Write("set/Limits.csv", kLimits);
    folder_.Write("set/Anchors.csv", "x;y\n1;1\n");
    for (const std::string name : {"Database.csv", "Test.csv"}) {
      folder_.Write("set/WIFI/" + name, kWifi);
      folder_.Write("set/Zigbee/" + name, kZigbee);
    }
  }

  Walk Read(const std::string& file, const ReaderSettings& settings = {}) const {
    return ReadWalk(IdentifyWalk(folder_.Path("set/" + file)), settings);
  }

  TemporaryFolder folder_;
};

// RSSI of one radio's anchor in the i-th second; 0 where there is none.
double RssiAt(const Walk& walk, Radio radio, const std::string& anchor, int second) {
  for (const RadioRow& row : walk.recording.radio_rows) {
    const Transmitter& sender = walk.recording.transmitters[row.transmitter];
    if (sender == Transmitter{radio, anchor} &&
        row.printed_ns - walk.recording.begin_ns == second * TimeNs{1'000'000'000}) {
      return row.rssi_dbm;
    }
  }
  return 0;
}

TEST_F(Swiblux, FilesOfAllRadiosAreOneRecordingPerName) {
  const Dataset set = OpenDataset(folder_.Path("set"));
  ASSERT_EQ(set.walks.size(), 2U);
  EXPECT_EQ(set.walks[0].id, "Database");
  EXPECT_EQ(set.walks[1].id, "Test");
  ASSERT_EQ(set.building.floors.size(), 1U);
  EXPECT_EQ(set.building.floors[0].min_corner, Eigen::Vector2d(-1, 0));
  EXPECT_EQ(set.building.floors[0].max_corner, Eigen::Vector2d(9, 4));
  EXPECT_EQ(OpenDataset(folder_.Path()).walks.at(1).id, "set__Test");
}

TEST_F(Swiblux, OneRecordingIsADatasetInItsRoom) {
  const Dataset one = OpenDataset(folder_.Path("set/Zigbee/Test.csv"));
  ASSERT_EQ(one.walks.size(), 1U);
  EXPECT_EQ(one.walks[0].id, "Test");
  EXPECT_EQ(one.building.floors.size(), 1U);
}

TEST_F(Swiblux, RowIsAPositionAndItsReadingsAtSecondI) {
  const Walk walk = Read("WIFI/Database.csv");
  ASSERT_EQ(walk.truth.waypoints.size(), 3U);
  EXPECT_EQ(walk.truth.waypoints[2].position, Eigen::Vector2d(5, 2));
  EXPECT_EQ(walk.truth.waypoints[2].time_ns, 2'000'000'000);
  EXPECT_GT(Read("WIFI/Test.csv").recording.begin_ns, walk.recording.end_ns);
  EXPECT_FLOAT_EQ(RssiAt(walk, Radio::kWifi, "b", 1), -50.5);
  EXPECT_FLOAT_EQ(RssiAt(walk, Radio::kZigbee, "a", 2), -64);
  EXPECT_EQ(RssiAt(walk, Radio::kWifi, "a", 1), 0) << "-92 is not heard";
  // Row 1 lies half a metre beside the first radio's, row 3 has none.
  EXPECT_EQ(walk.report.HazardCount("position_disagreement"), 2);
  EXPECT_EQ(walk.report.records.at("zigbee"), 4);
}

TEST_F(Swiblux, UnheardAnchorsAreReadingsOnRequest) {
  EXPECT_FLOAT_EQ(
      RssiAt(Read("WIFI/Test.csv", {.swiblux_keep_unheard = true}), Radio::kWifi, "a", 1), -92);
}

TEST_F(Swiblux, ReversalConcernsTheWifiTestAlone) {
  const ReaderSettings reverse = {.swiblux_reverse_wifi_test = true};
  const Walk test = Read("WIFI/Test.csv", reverse);
  EXPECT_FLOAT_EQ(RssiAt(test, Radio::kWifi, "a", 0), -45);
  EXPECT_FLOAT_EQ(RssiAt(test, Radio::kWifi, "a", 2), -40);
  EXPECT_FLOAT_EQ(RssiAt(test, Radio::kZigbee, "a", 0), -60);
  EXPECT_EQ(test.truth.waypoints[0].position, Eigen::Vector2d(1, 2));
  EXPECT_FLOAT_EQ(RssiAt(Read("WIFI/Database.csv", reverse), Radio::kWifi, "a", 0), -40);
}

TEST_F(Swiblux, BrokenRowsAreCounted) {
  folder_.Write("set/WIFI/Test.csv",
                "x;y;RSSI A;RSSI B\n1;2;-40;-50\n1;2;-40\nx;2;-40;-50\n1;2;nan;-50\n1;2;-40;-5");
  const Walk walk = Read("WIFI/Test.csv");
  EXPECT_EQ(walk.report.HazardCount("malformed"), 2);
  EXPECT_EQ(walk.report.HazardCount("non_finite"), 1);
  EXPECT_EQ(walk.report.HazardCount("cut_line"), 1);
  EXPECT_EQ(walk.truth.waypoints.size(), 2U);
}

TEST_F(Swiblux, OtherLimitsAreNoRoom) {
  folder_.Write("set/Limits.csv", "limits\n-1\n9\n4\n0\n");
  EXPECT_THROW(OpenDataset(folder_.Path("set")), InputError);
}

}  // namespace
}  // namespace walkgraph
