#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "solvers/batch_smoother.h"
#include "solvers/two_floors.h"
#include "solvers/window_smoother.h"

namespace walkgraph {
namespace {

using testing::TwoFloors;

std::vector<SlowStateEstimate> States(const EstimateResult& result, const std::string& name) {
  std::vector<SlowStateEstimate> states;
  for (const SlowStateEstimate& state : result.slow_states) {
    if (state.name == name) states.push_back(state);
  }
  return states;
}

double ZAt(const EstimateResult& result, double seconds) {
  return result.trajectory.At(TwoFloors::At(seconds)).position_m.z();
}

const std::vector<int> kStays = TwoFloors::Stays({0, 1, 0}, 60, 12);

TEST(Heights, AreTheLevelsOnThemAndTheBarometersBetween) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    TwoFloors house(seed);
    const EstimateResult result =
        BatchSmoother({}, {}).Estimate(house.site, house.Ride(kStays, 250.0));
    EXPECT_NEAR(ZAt(result, 30), 0.0, 0.1);
    EXPECT_NEAR(ZAt(result, 66), 0.5 * TwoFloors::kStoreyM, 0.3);
    EXPECT_NEAR(ZAt(result, 100), TwoFloors::kStoreyM, 0.1);
    EXPECT_EQ(result.trajectory.At(TwoFloors::At(100)).floor, 1);
    EXPECT_LT(std::sqrt(result.trajectory.At(TwoFloors::At(100)).variance_z_m2), 0.15);
  }
}

TEST(Heights, OffsetsComeOutWithinTheirSigmas) {
  int inside = 0, count = 0;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    TwoFloors house(seed);
    const EstimateResult result =
        BatchSmoother({}, {}).Estimate(house.site, house.Ride(kStays, -310.0, 0.002));
    for (const SlowStateEstimate& state : States(result, "barometric_offset_m")) {
      const double truth = -310.0 + 0.002 * SecondsBetween(TwoFloors::kStart, state.time_ns);
      EXPECT_LT(state.sigma, 0.2);
      inside += std::abs(state.value - truth) < 2 * state.sigma ? 1 : 0;
      ++count;
    }
  }
  ASSERT_GT(count, 200);
  EXPECT_GT(inside, 0.9 * count);
}

// Two phones on one walk: what one shows more than the other is what their offsets differ by.
TEST(Heights, TheDifferenceOfTwoPhonesIsThatOfTheirOffsets) {
  TwoFloors first(1), second(1);
  const auto offset = [](TwoFloors& house, const char* state, double offset_m) {
    const EstimateResult result =
        BatchSmoother({}, {}).Estimate(house.site, house.Ride(kStays, offset_m));
    return States(result, state).front().value;
  };
  EXPECT_NEAR(
      offset(first, "barometric_offset_m", 100.0) - offset(second, "barometric_offset_m", 96.25),
      3.75, 0.01);
  // At sea level 3.75 m are 0.45 hPa.
  EXPECT_NEAR(
      offset(first, "barometric_offset_hpa", -3.75) - offset(second, "barometric_offset_hpa", 0.0),
      0.45, 0.01);
}

TEST(Heights, TheWindowFindsThem) {
  TwoFloors house(2);
  const EstimateResult result =
      WindowSmoother({}, {}, {}).Estimate(house.site, house.Ride(kStays, 250.0));
  EXPECT_NEAR(ZAt(result, 30), 0.0, 0.3);
  EXPECT_NEAR(ZAt(result, 100), TwoFloors::kStoreyM, 0.3);
  EXPECT_EQ(result.trajectory.At(TwoFloors::At(100)).floor, 1);
  EXPECT_EQ(result.trajectory.At(TwoFloors::At(170)).floor, 0);
}

TEST(Heights, AreLeftOutWhereNothingSpeaksOfThem) {
  TwoFloors house(3);
  Evidence evidence = house.Ride(TwoFloors::Stays({1}, 30, 0), 0);
  evidence.barometric_height_m = {};
  evidence.barometric_height_sigma_m.clear();
  evidence.floor = 1;
  const EstimateResult result = BatchSmoother({}, {}).Estimate(house.site, evidence);
  EXPECT_EQ(ZAt(result, 10), TwoFloors::kStoreyM);
  EXPECT_TRUE(std::isnan(result.trajectory.poses.front().variance_z_m2));
}

}  // namespace
}  // namespace walkgraph
