#include "solvers/baselines/floor_tracker.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "solvers/two_floors.h"

namespace walkgraph {
namespace {

using testing::TwoFloors;

// Share of the seconds on a floor at which the path is on that floor.
double Accuracy(const FloorPath& path, const std::vector<int>& floor_by_second) {
  int right = 0, count = 0;
  for (std::size_t s = 0; s < floor_by_second.size(); ++s) {
    if (floor_by_second[s] == TwoFloors::kBetween) continue;
    ++count;
    right += path.At(TwoFloors::At(static_cast<double>(s))) == floor_by_second[s] ? 1 : 0;
  }
  return static_cast<double>(right) / count;
}

TEST(FloorTracker, FindsTheFloorOfAWalkThatStaysWhateverTheBarometersOffset) {
  for (const int floor : {0, 1}) {
    for (const double offset_m : {-300.0, 0.0, 120.5}) {
      TwoFloors house(7);
      const std::vector<int> stays = TwoFloors::Stays({floor}, 120, 0);
      const FloorTrack track = TrackFloors(house.site, house.Ride(stays, offset_m), {});
      EXPECT_EQ(Accuracy(track.path, stays), 1.0) << floor << " " << offset_m;
      EXPECT_GT(track.ProbabilityAt(floor, TwoFloors::At(60)), 0.9);
    }
  }
}

TEST(FloorTracker, FollowsALiftThatNoStepTellsOf) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    TwoFloors house(seed, 3);
    const std::vector<int> stays = TwoFloors::Stays({0, 2, 1, 2}, 60, 12);
    // The weather takes the barometer through most of a storey meanwhile.
    const Evidence evidence = house.Ride(stays, 250.0, 0.01);
    EXPECT_GT(Accuracy(TrackFloors(house.site, evidence, {}).path, stays), 0.98) << seed;
  }
}

TEST(FloorTracker, ADraughtIsNoStorey) {
  TwoFloors house(3);
  const std::vector<int> stays = TwoFloors::Stays({0}, 240, 0);
  Evidence evidence = house.Ride(stays, 50.0);
  for (std::size_t i = 120; i < 240; ++i) {
    evidence.barometric_height_m.value[i] += TwoFloors::kStoreyM;  // a door, for good
  }
  EXPECT_GT(Accuracy(TrackFloors(house.site, evidence, {}).path, stays), 0.95);
}

TEST(FloorTracker, WithoutABarometerTheRadioTells) {
  TwoFloors house(4);
  const std::vector<int> stays = TwoFloors::Stays({0, 1}, 120, 12);
  Evidence evidence = house.Ride(stays, 0);
  evidence.barometric_height_m = {};
  evidence.barometric_height_sigma_m.clear();
  EXPECT_GT(Accuracy(TrackFloors(house.site, evidence, {}).path, stays), 0.85);
}

TEST(FloorTracker, FloorsWithoutHeightsAreToldByTheRadioAlone) {
  TwoFloors house(4);
  const std::vector<int> stays = TwoFloors::Stays({0, 1}, 120, 12);
  const Evidence evidence = house.Ride(stays, 30.0);
  for (Floor& floor : house.site.building.floors) floor.height_m = 0;
  EXPECT_GT(Accuracy(TrackFloors(house.site, evidence, {}).path, stays), 0.85);
}

// The barometer alone sees a change, not where it begins; the prior says where people were
// surveyed.
TEST(FloorTracker, WithoutRadioTheBarometerTellsChanges) {
  TwoFloors house(5, 2);
  const std::vector<int> stays = TwoFloors::Stays({0, 1, 0}, 60, 12);
  Evidence evidence = house.Ride(stays, 77.0);
  evidence.readings.clear();
  EXPECT_GT(Accuracy(TrackFloors(house.site, evidence, {}).path, stays), 0.97);
}

// A walk that stays and hears nothing has only its height, which means something where the same
// phone was surveyed ten minutes before; a history of another model says nothing, and radio wins
// against a history that is wrong.
TEST(FloorTracker, TheSurveysBarometerTellsTheFloorOfAWalkThatStays) {
  const std::vector<int> stays = TwoFloors::Stays({1}, 120, 0);
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    TwoFloors house(seed);
    const Evidence heard = [&] {
      Evidence evidence = house.Ride(stays, 250.0);
      evidence.device = "phone";
      evidence.begin_unix_ns = evidence.begin_ns;
      return evidence;
    }();
    Evidence silent = heard;
    silent.readings.clear();
    const TimeNs before = heard.begin_ns - DurationNs(600);
    house.site.barometric_offsets = {{"phone", before, 250.3, 0.1}};
    EXPECT_EQ(Accuracy(TrackFloors(house.site, silent, {}).path, stays), 1.0) << seed;
    house.site.barometric_offsets = {{"other", before, 250.3, 0.1}};
    EXPECT_LT(TrackFloors(house.site, silent, {}).ProbabilityAt(1, TwoFloors::At(60)), 0.7) << seed;
    house.site.barometric_offsets = {{"phone", before, 180, 0.1}};
    EXPECT_EQ(Accuracy(TrackFloors(house.site, heard, {}).path, stays), 1.0) << seed;
  }
}

TEST(FloorTracker, AGivenFloorIsTheAnswer) {
  TwoFloors house(6);
  Evidence evidence = house.Ride(TwoFloors::Stays({0, 1}, 60, 12), 0);
  evidence.floor = 1;
  EXPECT_EQ(TrackFloors(house.site, evidence, {}).path.Floors(), std::vector<int>{1});
}

// With a lag nothing of later can matter; without one it is that of the whole walk.
TEST(FloorTracker, ALagHeedsNothingLater) {
  TwoFloors house(8);
  const std::vector<int> stays = TwoFloors::Stays({0, 1}, 60, 12);
  const Evidence whole = house.Ride(stays, 10.0);
  Evidence cut = whole;
  const TimeNs until = TwoFloors::At(80);
  cut.end_ns = until;
  std::erase_if(cut.readings, [&](const RadioReading& r) { return r.printed_ns > until; });
  while (cut.barometric_height_m.time_ns.back() > until) {
    cut.barometric_height_m.time_ns.pop_back();
    cut.barometric_height_m.value.pop_back();
    cut.barometric_height_sigma_m.pop_back();
  }
  // The grid of offsets is laid out over all heights, so that the two agree but for its cells.
  const FloorTrack early = TrackFloors(house.site, cut, {}, 10.0);
  const FloorTrack late = TrackFloors(house.site, whole, {}, 10.0);
  for (double s = 0; s <= 70; s += 2) {
    EXPECT_NEAR(early.ProbabilityAt(1, TwoFloors::At(s)), late.ProbabilityAt(1, TwoFloors::At(s)),
                0.05)
        << s;
  }
}

// Floors, offset and lag aside: each epoch's posterior adds up to one with "between".
TEST(FloorTracker, PosteriorsAreProbabilities) {
  TwoFloors house(9, 3);
  const FloorTrack track =
      TrackFloors(house.site, house.Ride(TwoFloors::Stays({2, 0}, 40, 12), 5.0), {});
  EXPECT_GE(track.probability.minCoeff(), 0.0);
  EXPECT_LE(track.probability.rowwise().sum().maxCoeff(), 1.0 + 1e-9);
  EXPECT_EQ(track.floors, (std::vector<int>{0, 1, 2}));
}

}  // namespace
}  // namespace walkgraph
