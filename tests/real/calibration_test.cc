// Noise of motion calibrated on recorded walks: within what people and phones can be.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "data/dataset.h"
#include "eval/calibrate/calibrate_motion.h"
#include "eval/loaded_walk.h"
#include "real/recorded_walks.h"

namespace walkgraph {
namespace {

// The museum's phones are held upright now and then, which leaves their unwrapped headings up to
// eight turns off, and its walks are long enough for a gyroscope to drift: neither may pass for a
// bias (0.1 rad/s) or a sideways step (0.4 m).
TEST(CalibrationRecorded, MotionIsThatOfPeopleAndPhones) {
  const char* root = std::getenv("WALKGRAPH_REAL_DATA");
  if (root == nullptr) GTEST_SKIP() << "WALKGRAPH_REAL_DATA is not set";
  const std::map<std::string, std::size_t> values_of = {{"/ilc20/data/site1/F2", 11U},
                                                        {"/ipin2023_t3", 14U}};
  for (const auto& [folder, values] : values_of) {
    const std::string path = root + folder;
    if (!std::filesystem::is_directory(path)) continue;
    const Dataset dataset = OpenDataset(path);
    const std::vector<LoadedWalk> walks = LoadRecordedWalks(dataset);
    std::vector<CalibrationWalk> with_truth;
    for (const LoadedWalk& walk : walks) with_truth.push_back({&walk.evidence, &walk.truth});
    FactorSettings settings;
    const auto calibrated = CalibrateMotion(dataset.building, with_truth, &settings);
    EXPECT_EQ(calibrated.size(), values) << folder;
    EXPECT_LT(settings.gyro_bias.prior_sigma_radps, 0.02) << folder;
    EXPECT_LT(settings.step.sigma_across_m, 0.2) << folder;
    EXPECT_LT(settings.step.sigma_along_m, 0.3) << folder;
    EXPECT_LT(settings.heading_increment.sigma_rad_per_sqrt_s, 0.05) << folder;
    EXPECT_LT(settings.absolute_heading.sigma_rad, 0.6) << folder;
    EXPECT_GT(settings.step_scale.prior_mean, 0.8) << folder;
    EXPECT_LT(settings.step_scale.prior_mean, 1.3) << folder;
  }
}

// Only the museum has barometers, and walks long enough for a bias to wander.
TEST(CalibrationRecorded, LongWalksWithBarometersSayMore) {
  const char* root = std::getenv("WALKGRAPH_REAL_DATA");
  if (root == nullptr) GTEST_SKIP() << "WALKGRAPH_REAL_DATA is not set";
  const std::string path = std::string(root) + "/ipin2023_t3";
  if (!std::filesystem::is_directory(path)) GTEST_SKIP() << path << " is missing";
  const Dataset dataset = OpenDataset(path);
  const std::vector<LoadedWalk> walks = LoadRecordedWalks(dataset);
  std::vector<CalibrationWalk> with_truth;
  for (const LoadedWalk& walk : walks) with_truth.push_back({&walk.evidence, &walk.truth});
  FactorSettings settings;
  std::set<std::string> keys;
  for (const CalibratedValue& value : CalibrateMotion(dataset.building, with_truth, &settings)) {
    keys.insert(value.key);
  }
  EXPECT_TRUE(keys.contains("noise.barometric.sigma_m"));
  EXPECT_TRUE(keys.contains("noise.barometric_offset.walk_m_per_sqrt_s"));
  EXPECT_TRUE(keys.contains("noise.gyro_bias.walk_radps_per_sqrt_s"));
  EXPECT_LT(settings.gyro_bias.walk_radps_per_sqrt_s, 1e-3);
  // Phones' barometers repeat to a decimetre, and the weather moves them by 0.1 to 1 hPa an hour.
  EXPECT_GT(settings.barometric.sigma_m, 0.05);
  EXPECT_LT(settings.barometric.sigma_m, 0.3);
  EXPECT_GT(settings.barometric_offset.walk_m_per_sqrt_s, 0.014);
  EXPECT_LT(settings.barometric_offset.walk_m_per_sqrt_s, 0.14);
}

}  // namespace
}  // namespace walkgraph
