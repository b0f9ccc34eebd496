// Noise of motion calibrated on recorded walks: within what people and phones can be.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
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
  for (const char* folder : {"/ilc20/data/site1/F2", "/ipin2023_t3"}) {
    const std::string path = std::string(root) + folder;
    if (!std::filesystem::is_directory(path)) continue;
    const Dataset dataset = OpenDataset(path);
    const std::vector<LoadedWalk> walks = LoadRecordedWalks(dataset);
    std::vector<CalibrationWalk> with_truth;
    for (const LoadedWalk& walk : walks) with_truth.push_back({&walk.evidence, &walk.truth});
    FactorSettings settings;
    const auto calibrated = CalibrateMotion(dataset.building, with_truth, &settings);
    EXPECT_EQ(calibrated.size(), 11U) << folder;
    EXPECT_LT(settings.gyro_bias.prior_sigma_radps, 0.02) << folder;
    EXPECT_LT(settings.step.sigma_across_m, 0.2) << folder;
    EXPECT_LT(settings.step.sigma_along_m, 0.3) << folder;
    EXPECT_LT(settings.heading_increment.sigma_rad_per_sqrt_s, 0.05) << folder;
    EXPECT_LT(settings.absolute_heading.sigma_rad, 0.6) << folder;
    EXPECT_GT(settings.step_scale.prior_mean, 0.8) << folder;
    EXPECT_LT(settings.step_scale.prior_mean, 1.3) << folder;
  }
}

}  // namespace
}  // namespace walkgraph
