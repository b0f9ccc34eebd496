#include "data/simulator/sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "data/dataset.h"
#include "data/formats/text_input.h"
#include "data/temporary_folder.h"

namespace walkgraph {
namespace {

namespace fs = std::filesystem;

// Content by path relative to the folder.
std::map<std::string, std::string> FilesBelow(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files[entry.path().lexically_relative(folder).string()] = ReadFileBytes(entry.path().string());
  }
  return files;
}

TEST(Sample, TheCommittedSampleIsWhatSeedOneGives) {
  const TemporaryFolder folder;
  SimulateSample(folder.Path(), 1);
  std::map<std::string, std::string> committed =
      FilesBelow(std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples");
  ASSERT_EQ(committed.erase("README.md"), 1U);
  const std::map<std::string, std::string> simulated = FilesBelow(folder.Path());
  ASSERT_EQ(simulated.size(), committed.size());
  std::size_t bytes = 0;
  for (const auto& [name, content] : simulated) {
    EXPECT_TRUE(committed.at(name) == content) << name << " differs";
    bytes += content.size();
  }
  EXPECT_LT(bytes, 2'000'000U);
}

TEST(Sample, AnotherSeedGivesOtherWalksInTheSameBuilding) {
  const Sample one = MakeSample(1);
  const Sample two = MakeSample(2);
  EXPECT_EQ(one.building.floors[0].outline, two.building.floors[0].outline);
  EXPECT_NE(one.walks[0].truth.waypoints[0].position, two.walks[0].truth.waypoints[0].position);
}

TEST(Sample, PeopleStayInTheCorridors) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Sample sample = MakeSample(seed);
    const Floor& floor = sample.building.floors.front();
    for (const SimulatedWalk& walk : sample.walks) {
      for (const WalkState& state : walk.path) {
        ASSERT_TRUE(InsidePolygons(floor.outline, state.position_m)) << walk.name;
        ASSERT_FALSE(InsidePolygons(floor.obstacles, state.position_m)) << walk.name;
      }
    }
  }
}

TEST(Sample, ReadsBackWithoutHazards) {
  const Dataset dataset = OpenDataset(std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples");
  EXPECT_EQ(dataset.walks.size(), 18U);
  EXPECT_EQ(dataset.building.floors.size(), 1U);
  for (const WalkFile& file : dataset.walks) {
    const Walk walk = ReadWalk(file);
    EXPECT_TRUE(walk.report.hazards.empty()) << file.id;
    EXPECT_GE(walk.truth.waypoints.size(), 4U) << file.id;
    EXPECT_GT(walk.recording.radio_rows.size(), 100U) << file.id;
  }
}

// Truth, gyroscope and accelerometer come from one motion: what the gyroscope integrates to about
// the vertical is the change of heading, and the mean specific force of a whole walk is gravity.
TEST(Sample, InertialSensorsFollowTheTruePath) {
  for (const SimulatedWalk& walk : MakeSample(1).walks) {
    const auto& gyro = walk.recording.gyroscope_radps;
    const auto& rotation = walk.recording.rotation_vector;
    double yaw = 0;
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < gyro.size(); ++i) {
      const Eigen::Quaterniond& attitude = rotation.value[std::min(i / 10, rotation.size() - 1)];
      yaw += (attitude * gyro.value[i]).z() * 0.02;
      force += attitude * walk.recording.accelerometer_mps2.value[i];
    }
    const double turned = walk.path.back().heading_rad - walk.path.front().heading_rad;
    const double duration_s = 0.02 * static_cast<double>(gyro.size());
    // 3 sigma of a constant bias of 0.3 deg/s, and the hand's wandering.
    EXPECT_NEAR(yaw, turned, 0.016 * duration_s + 0.15) << walk.name;
    force /= static_cast<double>(gyro.size());
    EXPECT_NEAR(force.norm(), 9.80665, 0.15) << walk.name;
    EXPECT_GT(force.normalized().z(), std::cos(0.04)) << walk.name;
  }
}

TEST(Sample, WifiRowsRepeatOldReadingsAsPhonesDo) {
  std::int64_t rows = 0;
  std::int64_t repeats = 0;
  for (const SimulatedWalk& walk : MakeSample(1).walks) {
    std::set<std::pair<std::uint32_t, TimeNs>> seen;
    for (const RadioRow& row : walk.recording.radio_rows) {
      ASSERT_LE(row.heard_ns, row.printed_ns);
      ++rows;
      repeats += seen.insert({row.transmitter, row.heard_ns}).second ? 0 : 1;
    }
  }
  const double share = static_cast<double>(repeats) / static_cast<double>(rows);
  EXPECT_NEAR(share, 0.42, 0.1);  // ilc20: 42 %
}

}  // namespace
}  // namespace walkgraph
