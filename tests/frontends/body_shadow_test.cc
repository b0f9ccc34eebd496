#include "frontends/radio_map/body_shadow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "frontends/radio_map/survey_shadows.h"
#include "frontends/radio_world.h"

namespace walkgraph {
namespace {

SurveyScan ScanAt(int floor, std::uint32_t transmitter, float rssi_dbm, float x_m,
                  double heading_rad) {
  SurveyScan scan;
  scan.floor = floor;
  scan.readings.push_back({transmitter, rssi_dbm, 0, {x_m, 0.0F}, static_cast<float>(heading_rad)});
  return scan;
}

TEST(BearingTest, PointsThereFromAfarAndVanishesAtThePlace) {
  const Eigen::Vector2d source(3, -4);
  EXPECT_NEAR(BearingOf(source, {3, 996}).value.y(), -1.0, 1e-4);
  EXPECT_TRUE(BearingOf(source, source).value.isZero());
  EXPECT_NEAR(BearingOf(source, {3 + kBearingSoftness, -4}).value.x(), -std::sqrt(0.5), 1e-12);
}

TEST(BearingTest, ItsDerivativeIsThatOfDifferences) {
  const Eigen::Vector2d source(3, -4), at(11, 2);
  constexpr double kStep = 1e-5;
  const Bearing bearing = BearingOf(source, at);
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(axis);
    const Eigen::Vector2d slope =
        (BearingOf(source, at + step).value - BearingOf(source, at - step).value) / (2 * kStep);
    EXPECT_TRUE(bearing.by_position.col(axis).isApprox(slope, 1e-8));
  }
}

TEST(BodyShadowTest, SourcesAreWhereTheyAreHeardLoudest) {
  // A reading 10 dB stronger weighs ten times as much.
  const SurveyScan near = ScanAt(0, 7, -50, 0, 0), far = ScanAt(0, 7, -60, 11, 0);
  const auto sources = LocateSources({&near, &far});
  ASSERT_EQ(sources.size(), 1U);
  EXPECT_NEAR(sources.at(7).x(), 1.0, 1e-6);
}

TEST(BodyShadowTest, StrengthensWhatLiesAheadAndWeakensWhatLiesBehind) {
  // The source is at the loud reading, x = 0; the quiet ones, far away, face it and turn their
  // backs on it. On another floor the source is elsewhere.
  std::vector<SurveyScan> scans = {
      ScanAt(0, 7, -30, 0, 0), ScanAt(0, 7, -90, 100, std::numbers::pi), ScanAt(0, 7, -90, 100, 0),
      ScanAt(1, 7, -30, 200, 0), ScanAt(1, 7, -90, 100, 0)};
  SetBodyShadows(2.0, &scans);
  const double most = 2.0 * 100 / std::hypot(100, kBearingSoftness);
  EXPECT_NEAR(scans[0].readings[0].shadow_db, 0.0, 1e-3);
  EXPECT_NEAR(scans[1].readings[0].shadow_db, most, 1e-3);
  EXPECT_NEAR(scans[2].readings[0].shadow_db, -most, 1e-3);
  EXPECT_NEAR(scans[4].readings[0].shadow_db, most, 1e-3);
}

// What a map keeps is enough to say what the survey took off.
TEST(BodyShadowTest, AMapGivesItsSurveysReadingsTheSameShadow) {
  RadioWorld world(3, 20);
  world.body_shadow_db = 3;
  const Site site = TrainSite(world.building, world.Survey(2.0), {});
  const RadioMap& map = site.maps.front();
  ASSERT_GT(map.body_shadow_db, 0.0);
  for (SurveyScan scan : site.scans) {
    const std::vector<SurveyReading> before = scan.readings;
    for (SurveyReading& reading : scan.readings) reading.shadow_db = 0;
    SetBodyShadow(map, &scan);
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_NEAR(scan.readings[i].shadow_db, before[i].shadow_db, 1e-4);
    }
  }
}

}  // namespace
}  // namespace walkgraph
