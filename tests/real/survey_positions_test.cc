// Survey positions on recorded walks, by waypoints that they were not told of.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "data/dataset.h"
#include "eval/loaded_walk.h"
#include "eval/survey_placement.h"
#include "real/recorded_walks.h"

namespace walkgraph {
namespace {

ErrorSummary LeftOutSummary(const Building& building, const std::vector<LoadedWalk>& walks,
                            SurveyPositions positions) {
  Settings settings;
  settings.survey.positions = positions;
  std::vector<WaypointError> errors;
  for (const LoadedWalk& walk : walks) {
    const std::vector<WaypointError> more =
        LeftOutErrors(building, walk.truth, walk.evidence, settings);
    errors.insert(errors.end(), more.begin(), more.end());
  }
  return Summarise(errors);
}

// Half of the inner waypoints are left out, and most of them stand at corners: straight lines must
// do badly, and the smoother well, at any noise that is not absurd (the defaults here).
TEST(SurveyPositionsRecorded, TheSmootherGoesRoundCorners) {
  const char* root = std::getenv("WALKGRAPH_REAL_DATA");
  if (root == nullptr) GTEST_SKIP() << "WALKGRAPH_REAL_DATA is not set";
  for (const char* folder : {"/ilc20/data/site1/F2", "/ipin2023_t3"}) {
    const std::string path = std::string(root) + folder;
    if (!std::filesystem::is_directory(path)) continue;
    const Dataset dataset = OpenDataset(path);
    const std::vector<LoadedWalk> walks = LoadRecordedWalks(dataset);
    const ErrorSummary straight =
        LeftOutSummary(dataset.building, walks, SurveyPositions::kWalkedDistance);
    const ErrorSummary smooth = LeftOutSummary(dataset.building, walks, SurveyPositions::kSmoother);
    EXPECT_GT(smooth.n, 200) << folder;
    EXPECT_LT(smooth.mean_m, 0.6 * straight.mean_m) << folder;
    EXPECT_LT(smooth.median_m, 1.2) << folder;
  }
}

}  // namespace
}  // namespace walkgraph
