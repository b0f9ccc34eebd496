// The readers on the recorded walks. Set WALKGRAPH_REAL_DATA to the folder that holds ilc20/ and
// ipin2023_t3/; without it every test here reports itself as skipped.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "data/angle.h"
#include "data/dataset.h"

namespace walkgraph {
namespace {

class RealReaders : public testing::Test {
 protected:
  void SetUp() override {
    const char* root = std::getenv("WALKGRAPH_REAL_DATA");
    if (root == nullptr) GTEST_SKIP() << "WALKGRAPH_REAL_DATA is not set";
    root_ = root;
    for (const std::string& folder : {Ilc20Site(), Ipin2023()}) {
      if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no folder " << folder;
    }
  }

  std::string Ilc20Site() const { return root_ + "/ilc20/data/site1"; }
  std::string Ipin2023() const { return root_ + "/ipin2023_t3"; }

  std::string root_;
};

TEST_F(RealReaders, FindsEveryWalkOfAnIlc20SiteWithItsFloor) {
  const Dataset site = OpenDataset(Ilc20Site());
  ASSERT_EQ(site.building.floors.size(), 3U);
  EXPECT_EQ(site.building.floors.front().name, "B1");
  EXPECT_EQ(site.building.floors.front().number, -1);
  EXPECT_EQ(site.building.floors.back().number, 1);
  EXPECT_GT(site.walks.size(), 300U);
  EXPECT_TRUE(site.unrecognised.empty());
  for (const WalkFile& walk : site.walks) {
    ASSERT_TRUE(walk.floor.has_value());
    EXPECT_NE(site.building.FindFloor(*walk.floor), nullptr);
  }
  EXPECT_TRUE(site.walks.back().id.starts_with("F2__path_data_files__"));
}

TEST_F(RealReaders, OpensAFloorAndItsPathFolderLikeTheSite) {
  const Dataset floor = OpenDataset(Ilc20Site() + "/F1");
  const Dataset paths = OpenDataset(Ilc20Site() + "/F1/path_data_files/");
  ASSERT_EQ(floor.building.floors.size(), 1U);
  ASSERT_EQ(paths.building.floors.size(), 1U);
  EXPECT_EQ(floor.building.floors[0].outline, paths.building.floors[0].outline);
  ASSERT_EQ(floor.walks.size(), paths.walks.size());
  EXPECT_EQ(floor.walks[0].id, "path_data_files__" + paths.walks[0].id);
  EXPECT_EQ(floor.walks[0].floor, paths.walks[0].floor);
}

// The plan's coordinates are right only if people walk inside the outline and outside the shops.
TEST_F(RealReaders, WaypointsLieInsideTheOutlineAndOutsideTheShops) {
  const Dataset site = OpenDataset(Ilc20Site());
  int inside_outline = 0;
  int outside_obstacles = 0;
  int total = 0;
  for (const WalkFile& file : site.walks) {
    for (const Waypoint& waypoint : ReadWalk(file).truth.waypoints) {
      const Floor* floor = site.building.FindFloor(waypoint.floor);
      ASSERT_NE(floor, nullptr);
      ++total;
      inside_outline += InsidePolygons(floor->outline, waypoint.position) ? 1 : 0;
      outside_obstacles += InsidePolygons(floor->obstacles, waypoint.position) ? 0 : 1;
    }
  }
  ASSERT_GT(total, 2000);
  EXPECT_GT(inside_outline, 0.99 * total);
  EXPECT_GT(outside_obstacles, 0.95 * total);
}

TEST_F(RealReaders, Ilc20StreamsHaveTheRatesAndSizesOfTheSensors) {
  const Dataset site = OpenDataset(Ilc20Site());
  for (const WalkFile& file : site.walks) {
    const Walk walk = ReadWalk(file);
    const Recording& recording = walk.recording;
    ASSERT_EQ(walk.report.HazardCount("malformed"), 0) << file.path;
    ASSERT_GE(walk.truth.waypoints.size(), 2U) << file.path;
    EXPECT_EQ(static_cast<std::int64_t>(recording.accelerometer_mps2.size() +
                                        walk.report.HazardCount("duplicate_time")),
              walk.report.records.at("TYPE_ACCELEROMETER"));
    double sum = 0;
    for (const Eigen::Vector3d& a : recording.accelerometer_mps2.value) sum += a.norm();
    EXPECT_NEAR(sum / static_cast<double>(recording.accelerometer_mps2.size()), 9.8, 0.7);
    for (const RadioRow& row : recording.radio_rows) ASSERT_LE(row.heard_ns, row.printed_ns);
  }
}

TEST_F(RealReaders, GroupsTheIpinLogsByTrial) {
  const Dataset museum = OpenDataset(Ipin2023());
  EXPECT_EQ(museum.walks.size(), 38U);
  std::map<std::string, int> repetitions;
  for (const WalkFile& walk : museum.walks) ++repetitions[walk.trial];
  EXPECT_EQ(repetitions.size(), 10U);
  EXPECT_EQ(repetitions.at("Trial51"), 2);
  EXPECT_EQ(repetitions.at("Trial25"), 4);
}

// Reference point 9001 stands in the picture at the left edge, 58.7 m left of the centre and 22 m
// above it: the frame's rotation has the right sense only if the surveyed coordinates land there.
TEST_F(RealReaders, FloorplansTurnTheRightWay) {
  const Dataset museum = OpenDataset(Ipin2023());
  ASSERT_TRUE(museum.building.origin.has_value());
  const Eigen::Vector2d point =
      Wgs84ToBuilding(49.4611492539213, 11.1102840572794, *museum.building.origin);
  EXPECT_NEAR(point.x(), -58.7, 0.5);
  EXPECT_NEAR(point.y(), 22.0, 0.5);
  const Floor* middle = museum.building.FindFloor(-1);
  ASSERT_NE(middle, nullptr);
  EXPECT_NEAR(middle->image.max_corner.x() - middle->image.min_corner.x(), 132.06, 0.01);
}

TEST_F(RealReaders, IpinTruthVisitsTheFloorsOfTheBuildingInside) {
  const Dataset museum = OpenDataset(Ipin2023());
  for (const WalkFile& file : museum.walks) {
    const Truth truth = ToBuildingFrame(ReadWalk(file).truth, museum.building);
    ASSERT_GE(truth.waypoints.size(), 10U) << file.id;
    std::set<int> floors;
    for (const Waypoint& waypoint : truth.waypoints) {
      const Floor* floor = museum.building.FindFloor(waypoint.floor);
      ASSERT_NE(floor, nullptr);
      EXPECT_TRUE((waypoint.position.array() > floor->min_corner.array()).all());
      EXPECT_TRUE((waypoint.position.array() < floor->max_corner.array()).all());
      floors.insert(waypoint.floor);
    }
    EXPECT_EQ(floors.size(), file.trial == "Trial51" ? 3U : 1U) << file.id;
  }
}

// The application's stamps jitter by tens of milliseconds, the sensor's own do not.
TEST_F(RealReaders, IpinSamplesHaveTheSensorsEvenIntervals) {
  for (const WalkFile& file : OpenDataset(Ipin2023()).walks) {
    const Walk walk = ReadWalk(file);
    EXPECT_EQ(walk.report.HazardCount("malformed"), 0) << file.id;
    EXPECT_EQ(walk.report.HazardCount("heard_after_printed"), 0) << file.id;
    EXPECT_EQ(walk.report.HazardCount("sensor_clock_jump"), 0) << file.id;
    const std::vector<TimeNs>& time_ns = walk.recording.gyroscope_radps.time_ns;
    ASSERT_EQ(static_cast<std::int64_t>(time_ns.size()), walk.report.records.at("GYRO"));
    std::vector<TimeNs> interval;
    for (std::size_t i = 1; i < time_ns.size(); ++i)
      interval.push_back(time_ns[i] - time_ns[i - 1]);
    std::sort(interval.begin(), interval.end());
    const TimeNs median = interval[interval.size() / 2];
    const TimeNs p99 = interval[interval.size() * 99 / 100];
    EXPECT_GT(interval.front(), 0);
    EXPECT_LT(p99 - median, 2 * kNsPerMs) << file.id;
  }
}

TEST_F(RealReaders, NoRadioRowIsLost) {
  for (const std::string& path : {Ilc20Site() + "/F1", Ipin2023()}) {
    for (const WalkFile& file : OpenDataset(path).walks) {
      const Walk walk = ReadWalk(file);
      std::int64_t rows = 0;
      for (const char* type : {"TYPE_WIFI", "TYPE_BEACON", "WIFI", "BLE4"}) {
        const auto found = walk.report.records.find(type);
        if (found != walk.report.records.end()) rows += found->second;
      }
      EXPECT_EQ(static_cast<std::int64_t>(walk.recording.radio_rows.size()),
                rows - walk.report.HazardCount("out_of_range"))
          << file.id;
    }
  }
}

// Between seconds 40 and 60 the phone stands still: there the rotation vector must turn the
// measured specific force onto the vertical.
TEST_F(RealReaders, IpinRotationVectorAgreesWithGravity) {
  for (const WalkFile& file : OpenDataset(Ipin2023()).walks) {
    const Recording recording = ReadWalk(file).recording;
    const auto& acceleration = recording.accelerometer_mps2;
    const auto& rotation = recording.rotation_vector;
    Eigen::Vector3d up = Eigen::Vector3d::Zero();
    std::size_t r = 0;
    for (std::size_t i = 0; i < acceleration.size(); ++i) {
      const TimeNs time = acceleration.time_ns[i];
      if (time < 45 * kNsPerSecond || time > 55 * kNsPerSecond) continue;
      while (r + 1 < rotation.size() && rotation.time_ns[r] < time) ++r;
      up += rotation.value[r] * acceleration.value[i];
    }
    const double tilt_deg = RadiansToDegrees(std::acos(up.normalized().z()));
    EXPECT_LT(tilt_deg, 3.0) << file.id;
  }
}

}  // namespace
}  // namespace walkgraph
