#include "frontends/radio_map/barometric_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace walkgraph {
namespace {

constexpr TimeNs kNoon = 1'686'700'000 * kNsPerSecond;
constexpr double kWalk = 0.03;  // m/sqrt(s): 0.3 m in 100 s

Building TwoLevels() {
  Building building;
  building.floors.resize(2);
  building.floors[0].number = 0;
  building.floors[1].number = 1;
  building.floors[1].height_m = 4;
  return building;
}

// A phone that reads `offset_m` too much and walks up from floor 0 to floor 1.
Evidence Climb(double offset_m) {
  Evidence evidence;
  evidence.device = "phone";
  evidence.begin_ns = 0;
  evidence.end_ns = DurationNs(100);
  evidence.begin_unix_ns = kNoon;
  for (int s = 0; s <= 100; ++s) {
    const double true_m = s < 50 ? 0 : s < 56 ? (s - 50) * 4.0 / 6 : 4;
    evidence.barometric_height_m.push_back(DurationNs(s), true_m + offset_m);
    evidence.barometric_height_sigma_m.push_back(0.1);
  }
  return evidence;
}

SurveyWalk Walked(const Evidence& evidence) {
  SurveyWalk walk{&evidence, {}};
  for (const auto& [s, floor] : {std::pair(0, 0), {52, 0}, {53, 1}, {100, 1}}) {
    PoseEstimate pose;
    pose.time_ns = DurationNs(s);
    pose.floor = floor;
    walk.trajectory.poses.push_back(pose);
  }
  return walk;
}

TEST(BarometricHistory, MeasuresTheOffsetDespiteTheStairs) {
  const Evidence evidence = Climb(312.5);
  const auto offset = MeasureBarometricOffset(TwoLevels(), Walked(evidence));
  ASSERT_TRUE(offset.has_value());
  EXPECT_NEAR(offset->offset_m, 312.5, 1e-9);
  EXPECT_NEAR(offset->sigma_m, 0.1, 1e-9);
  EXPECT_EQ(offset->unix_ns, kNoon + DurationNs(50));
}

TEST(BarometricHistory, NeedsAPhoneATimeAndHeights) {
  Evidence evidence = Climb(1);
  EXPECT_FALSE(MeasureBarometricOffset(Building(), Walked(evidence)).has_value());
  evidence.begin_unix_ns.reset();
  EXPECT_FALSE(MeasureBarometricOffset(TwoLevels(), Walked(evidence)).has_value());
  EXPECT_FALSE(PriorOfOffset({{"phone", kNoon, 312, 0.1}}, evidence, kWalk).has_value());
  evidence = Climb(1);
  evidence.device.clear();
  EXPECT_FALSE(MeasureBarometricOffset(TwoLevels(), Walked(evidence)).has_value());
}

TEST(BarometricHistory, PredictsFromTheNearestInTimeOfTheSameModel) {
  const Evidence now = Climb(0);
  const std::vector<SurveyedOffset> history = {
      {"phone", kNoon - DurationNs(100), 312, 0.1},
      {"phone", kNoon + DurationNs(90'000), 315, 0.1},
      {"other", kNoon, 280, 0.1},
  };
  const auto prior = PriorOfOffset(history, now, kWalk);
  ASSERT_TRUE(prior.has_value());
  EXPECT_EQ(prior->mean_m, 312);
  // The two predict each other within their 9 m.
  EXPECT_NEAR(prior->sigma_m, std::hypot(0.1, 0.3), 1e-9);
  EXPECT_FALSE(PriorOfOffset({{"other", kNoon, 280, 0.1}}, now, kWalk).has_value());
}

// Two phones of one model, 30 m apart, turn and turn about: the history predicts nothing.
TEST(BarometricHistory, WidensWhereTheHistoryContradictsItself) {
  std::vector<SurveyedOffset> history;
  for (int i = 1; i <= 8; ++i) {
    history.push_back({"phone", kNoon - DurationNs(100.0 * i), i % 2 == 0 ? 300.0 : 330.0, 0.1});
  }
  const auto prior = PriorOfOffset(history, Climb(0), kWalk);
  ASSERT_TRUE(prior.has_value());
  EXPECT_GT(prior->sigma_m, 20);
}

}  // namespace
}  // namespace walkgraph
