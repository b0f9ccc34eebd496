#include "frontends/radio_map/direction_bias.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "radio_world.h"

namespace walkgraph {
namespace {

// Aisles walked to and fro at 1 m/s, so that a lag moves readings both ways and every place is
// passed facing both.
std::vector<SurveyWalk> WalkBothWays(RadioWorld* world) {
  std::vector<SurveyWalk> walks;
  for (double y = 0.5; y < RadioWorld::kHeightM; y += 1.5) {
    walks.push_back(world->Walk({0, y}, {RadioWorld::kWidthM, y}));
    walks.push_back(world->Walk({RadioWorld::kWidthM, y + 0.7}, {0, y + 0.7}));
  }
  return walks;
}

DirectionBias BiasOf(const RadioWorld& world, const std::vector<SurveyWalk>& walks,
                     const TrainerSettings& settings = {}) {
  Site site;
  site.transmitters = world.transmitters();
  std::vector<std::vector<std::int32_t>> site_index;
  for (std::size_t i = 0; i < walks.size(); ++i) {
    AppendSurveyPath(walks[i].trajectory, static_cast<std::uint32_t>(i), &site.path);
    site_index.push_back(MatchTransmitters(site, *walks[i].evidence));
  }
  return CalibrateDirectionBias(
      {world.building, walks, site_index, site.path, Radio::kWifi, settings});
}

DirectionBias BiasBothWays(double stamped_early_s, double body_shadow_db,
                           const TrainerSettings& settings = {}) {
  RadioWorld world(11, 40);
  world.stamped_early_s = stamped_early_s;
  world.body_shadow_db = body_shadow_db;
  return BiasOf(world, WalkBothWays(&world), settings);
}

TEST(DirectionBiasTest, FindsALagAndNoShadow) {
  for (const double lag_s : {-0.5, 0.0, 1.2}) {
    const DirectionBias found = BiasBothWays(lag_s, 0);
    EXPECT_NEAR(found.lag_s, lag_s, 0.35);
    EXPECT_NEAR(found.body_shadow_db, 0.0, 0.5);
  }
}

// Right beside a transmitter, where its bearing is not known, a shadow looks like a lag: 40 of them
// in a small hall are the worst case.
TEST(DirectionBiasTest, FindsAShadowAndLittleLag) {
  const DirectionBias shaded = BiasBothWays(0, 3);
  EXPECT_NEAR(shaded.body_shadow_db, 3.0, 0.5);
  TrainerSettings settings;
  settings.shade_readings = false;
  const DirectionBias mistaken = BiasBothWays(0, 3, settings);
  EXPECT_GT(mistaken.lag_s, 1.5);
  EXPECT_LT(std::abs(shaded.lag_s), 0.4 * mistaken.lag_s);
  EXPECT_EQ(mistaken.body_shadow_db, 0.0);
}

TEST(DirectionBiasTest, WhatIsSwitchedOffStaysZero) {
  TrainerSettings settings;
  settings.calibrate_lag = false;
  const DirectionBias shadow = BiasBothWays(1.2, 3, settings);
  EXPECT_EQ(shadow.lag_s, 0.0);
  EXPECT_GT(shadow.body_shadow_db, 2.5);
  settings.shade_readings = false;
  EXPECT_EQ(BiasBothWays(1.2, 3, settings).body_shadow_db, 0.0);
}

TEST(DirectionBiasTest, IsNoneWhereTooFewWalksTell) {
  RadioWorld world(11, 40);
  world.stamped_early_s = 1.2;
  world.body_shadow_db = 3;
  std::vector<SurveyWalk> walks = WalkBothWays(&world);
  walks.resize(4);
  const DirectionBias found = BiasOf(world, walks);
  EXPECT_EQ(found.lag_s, 0.0);
  EXPECT_EQ(found.body_shadow_db, 0.0);
}

// A survey of one direction has the shadow in its fields, and nothing is left for the readings.
TEST(DirectionBiasTest, OneWayLeavesTheShadowInTheFields) {
  RadioWorld world(5, 40);
  world.body_shadow_db = 3;
  const DirectionBias found = BiasOf(world, world.Survey(1.5));
  EXPECT_LT(found.body_shadow_db, 0.5);
  EXPECT_NEAR(found.lag_s, 0.0, 0.5);
}

}  // namespace
}  // namespace walkgraph
