#include "eval/survey_placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "eval/config.h"
#include "frontends/radio_map/survey_positions.h"
#include "solvers/turning_walk.h"

namespace walkgraph {
namespace {

using testing::TurningWalk;

Settings SettingsWith(const char* assignment) {
  Settings settings;
  ApplyOverrides({ParseSetFlag(assignment)}, &settings);
  return settings;
}

double MaxError(const std::vector<WaypointError>& errors) {
  double largest = 0;
  for (const WaypointError& error : errors) largest = std::max(largest, error.error_m);
  return largest;
}

// Only the waypoints that were not told count: of five those with index 1 and 3, and the second of
// them is near the corner that only the smoother sees.
TEST(SurveyPlacement, LeftOutWaypointsTellTheWaysApart) {
  const TurningWalk walk;
  const Truth truth = walk.WaypointsAt({0, 2, 4, 11, 22});
  const auto smooth =
      LeftOutErrors({}, truth, walk.evidence, SettingsWith("radio_map.positions=smoother"));
  const auto straight =
      LeftOutErrors({}, truth, walk.evidence, SettingsWith("radio_map.positions=walked_distance"));
  ASSERT_EQ(smooth.size(), 2U);
  ASSERT_EQ(straight.size(), 2U);
  EXPECT_LT(MaxError(smooth), 1e-3);
  EXPECT_LT(straight[0].error_m, 1e-6);
  EXPECT_GT(straight[1].error_m, 3.0);
  EXPECT_TRUE(LeftOutErrors({}, walk.WaypointsAt({0, 22}), walk.evidence, {}).empty());
}

TEST(SurveyPlacement, WalkedDistanceStandsInForASmootherWithoutAnswer) {
  TurningWalk walk;
  const Truth truth = walk.WaypointsAt({0, 22});
  const Settings settings = SettingsWith("radio_map.positions=smoother");
  EXPECT_FALSE(PlaceSurveyWalk({}, truth, walk.evidence, settings).fell_back);
  walk.evidence.steps.clear();
  const SurveyPlacement placement = PlaceSurveyWalk({}, truth, walk.evidence, settings);
  EXPECT_TRUE(placement.fell_back);
  const Trajectory expected = SurveyTrajectory(truth, walk.evidence);
  ASSERT_EQ(placement.trajectory.poses.size(), expected.poses.size());
  for (std::size_t i = 0; i < expected.poses.size(); ++i) {
    EXPECT_EQ(placement.trajectory.poses[i].position_m, expected.poses[i].position_m);
  }
  // Nobody falls back to what was asked for.
  EXPECT_FALSE(
      PlaceSurveyWalk({}, truth, walk.evidence, SettingsWith("radio_map.positions=walked_distance"))
          .fell_back);
}

}  // namespace
}  // namespace walkgraph
