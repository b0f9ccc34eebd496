#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "frontends/radio_map/trainer.h"
#include "frontends/radio_world.h"

namespace walkgraph {
namespace {

// Routes that were each surveyed as lying some 5 m from where they are, and walked four times. Told
// that they repeat one another, calibration asks how the map does on routes that it does not know,
// where their displacement shows; not told, it finds every route where the map has it.
std::vector<SurveyWalk> Repeated(RadioWorld* world, bool told) {
  std::vector<SurveyWalk> walks;
  const std::vector<SurveyWalk> survey = world->Survey(3.0, 60.0, 5.0);
  for (int repetition = 0; repetition < 4; ++repetition) {
    for (std::size_t i = 0; i < survey.size(); ++i) {
      walks.push_back(survey[i]);
      if (told) walks.back().trial = std::to_string(i);
    }
  }
  return walks;
}

TEST(TrialCalibration, ARepeatedRouteIsNoNewOne) {
  RadioWorld told_world(1), untold_world(1);
  const Site told = TrainSite(told_world.building, Repeated(&told_world, true), {});
  const Site untold = TrainSite(untold_world.building, Repeated(&untold_world, false), {});
  ASSERT_EQ(told.maps.size(), 1u);
  EXPECT_GE(told.maps[0].map_error_sigma_m, 1.4 * untold.maps[0].map_error_sigma_m);
}

// What is chosen from a ladder jumps by whole rungs, on a survey of few walks by several.
TEST(TrialCalibration, OneWalkLessMovesItLittle) {
  RadioWorld world(2);
  const std::vector<SurveyWalk> walks = world.Survey(3.0);
  const Site all = TrainSite(world.building, walks, {});
  double moved = 0;  // octaves
  for (std::size_t left_out = 0; left_out < walks.size(); ++left_out) {
    std::vector<SurveyWalk> fewer = walks;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(left_out));
    const Site site = TrainSite(world.building, fewer, {});
    moved = std::max(moved, std::abs(std::log2(site.maps[0].n_eff / all.maps[0].n_eff)));
    moved = std::max(
        moved, std::abs(std::log2(site.maps[0].map_error_sigma_m / all.maps[0].map_error_sigma_m)));
  }
  EXPECT_LT(moved, 0.5);
}

TEST(TrialCalibration, WalksWithoutATrialAreTrialsOfTheirOwn) {
  RadioWorld world(1);
  const Site site = TrainSite(world.building, world.Survey(6.0), {});
  for (const SurveyScan& scan : site.scans) EXPECT_EQ(scan.trial, scan.walk);
}

TEST(TrialCalibration, ScansNameTheFirstWalkOfTheirTrial) {
  RadioWorld world(1);
  std::vector<SurveyWalk> walks = world.Survey(6.0);
  ASSERT_GT(walks.size(), 3u);
  const std::string name(1, 'a');
  walks[1].trial = walks[3].trial = name;
  const Site site = TrainSite(world.building, walks, {});
  for (const SurveyScan& scan : site.scans) {
    EXPECT_EQ(scan.trial, scan.walk == 3 ? 1u : scan.walk);
  }
}

}  // namespace
}  // namespace walkgraph
