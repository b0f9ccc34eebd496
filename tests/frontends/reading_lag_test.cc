#include "frontends/radio_map/reading_lag.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "frontends/radio_map/site_file.h"
#include "radio_world.h"

namespace walkgraph {
namespace {

// Aisles walked to and fro at 1 m/s, so that a lag moves readings both ways.
std::vector<SurveyWalk> WalkBothWays(RadioWorld* world) {
  std::vector<SurveyWalk> walks;
  for (double y = 0.5; y < RadioWorld::kHeightM; y += 1.5) {
    walks.push_back(world->Walk({0, y}, {RadioWorld::kWidthM, y}));
    walks.push_back(world->Walk({RadioWorld::kWidthM, y + 0.7}, {0, y + 0.7}));
  }
  return walks;
}

double LagOf(double stamped_early_s) {
  RadioWorld world(11, 40);
  world.stamped_early_s = stamped_early_s;
  return TrainSite(world.building, WalkBothWays(&world), {}).reading_lag_s[0];
}

TEST(ReadingLagTest, IsFoundFromWalksInBothDirections) {
  EXPECT_NEAR(LagOf(0.0), 0.0, 0.35);
  EXPECT_NEAR(LagOf(1.2), 1.2, 0.35);
}

TEST(ReadingLagTest, IsNoneWhereNotCalibratedOrNotToBeLearnt) {
  TrainerSettings off;
  off.calibrate_lag = false;
  RadioWorld world(11, 40);
  world.stamped_early_s = 1.2;
  const std::vector<SurveyWalk> walks = WalkBothWays(&world);
  EXPECT_EQ(TrainSite(world.building, walks, off).reading_lag_s[0], 0.0);
  const std::vector<SurveyWalk> few(walks.begin(), walks.begin() + 4);
  EXPECT_EQ(TrainSite(world.building, few, {}).reading_lag_s[0], 0.0);
}

TEST(ReadingLagTest, MovesReadingsOfItsRadioAndKeepsTheirAge) {
  Site site;
  site.reading_lag_s = {0.5, -0.25};
  Evidence evidence;
  evidence.transmitters = {{Radio::kWifi, "ap"}, {Radio::kBeacon, "tag"}};
  const TimeNs at = 1'560'000'000 * kNsPerSecond;
  evidence.readings = {{at, at + kNsPerSecond, 0, -60.0F}, {at + 1, at + 1, 1, -70.0F}};
  const Evidence aligned = AlignReadings(site, evidence);
  ASSERT_EQ(aligned.readings.size(), 2U);
  // In order of the new times: the beacon comes first.
  EXPECT_EQ(aligned.readings[0].transmitter, 1U);
  EXPECT_EQ(aligned.readings[0].heard_ns, at + 1 - kNsPerSecond / 4);
  EXPECT_EQ(aligned.readings[1].heard_ns, at + kNsPerSecond / 2);
  EXPECT_EQ(aligned.readings[1].printed_ns - aligned.readings[1].heard_ns, kNsPerSecond);
}

TEST(ReadingLagTest, IsKeptInTheSiteFile) {
  Site site;
  site.reading_lag_s = {1.25, -0.5};
  EXPECT_EQ(ParseSite(SerializeSite(site), "site").reading_lag_s, site.reading_lag_s);
}

}  // namespace
}  // namespace walkgraph
