// The readers on the recorded walks. Set WALKGRAPH_REAL_DATA to the folder that holds ilc20/ and
// ipin2023_t3/; without it every test here reports itself as skipped.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "data/dataset.h"

namespace walkgraph {
namespace {

class RealReaders : public testing::Test {
 protected:
  void SetUp() override {
    const char* root = std::getenv("WALKGRAPH_REAL_DATA");
    if (root == nullptr) GTEST_SKIP() << "WALKGRAPH_REAL_DATA is not set";
    root_ = root;
    if (!std::filesystem::is_directory(Ilc20Site())) GTEST_SKIP() << "no ilc20 under " << root_;
  }

  std::string Ilc20Site() const { return root_ + "/ilc20/data/site1"; }

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

}  // namespace
}  // namespace walkgraph
