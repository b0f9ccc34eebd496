#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "frontends/radio_map/sweeps.h"

namespace walkgraph {
namespace {

// Unix time of the recorded walks: large enough that a sum of a few times would overflow.
constexpr TimeNs kStart = 1'560'000'000'000'000'000;

TimeNs Ms(std::int64_t milliseconds) { return kStart + milliseconds * kNsPerMs; }

// Random readings of both radios: each heard up to 3 s before it was printed, Wi-Fi printed every
// two seconds.
Evidence RandomReadings(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::int64_t> time(0, 30'000), age(0, 3'000);
  Evidence evidence;
  evidence.transmitters = {{Radio::kWifi, "a"}, {Radio::kBeacon, "b"}, {Radio::kWifi, "c"}};
  for (std::uint32_t i = 0; i < 300; ++i) {
    const std::uint32_t transmitter = i % 3;
    const std::int64_t at = time(random);
    const std::int64_t printed = transmitter == 1 ? at : at / 2'000 * 2'000;
    evidence.readings.push_back(
        {Ms(printed - (transmitter == 1 ? 0 : age(random))), Ms(printed), transmitter, -70});
  }
  std::sort(evidence.readings.begin(), evidence.readings.end(),
            [](const RadioReading& a, const RadioReading& b) { return a.heard_ns < b.heard_ns; });
  return evidence;
}

TEST(GroupSweepsTest, EveryReadingIsInExactlyOneSweepOfItsRadio) {
  const Evidence evidence = RandomReadings(1);
  std::vector<int> seen(evidence.readings.size(), 0);
  for (const Radio radio : {Radio::kWifi, Radio::kBeacon}) {
    for (const Sweep& sweep : GroupSweeps(evidence, radio)) {
      EXPECT_FALSE(sweep.readings.empty());
      for (const std::size_t i : sweep.readings) {
        ++seen[i];
        EXPECT_EQ(evidence.transmitters[evidence.readings[i].transmitter].radio, radio);
      }
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ssize(seen));
}

TEST(GroupSweepsTest, WifiSweepsAreWhatWasPrintedTogether) {
  const Evidence evidence = RandomReadings(2);
  std::set<TimeNs> printed;
  for (const Sweep& sweep : GroupSweeps(evidence, Radio::kWifi)) {
    const TimeNs own = evidence.readings[sweep.readings.front()].printed_ns;
    EXPECT_TRUE(printed.insert(own).second) << "two sweeps were printed at once";
    for (const std::size_t i : sweep.readings) EXPECT_EQ(evidence.readings[i].printed_ns, own);
  }
}

TEST(GroupSweepsTest, BeaconSweepsAreSecondsOfTheClock) {
  Evidence evidence;
  evidence.transmitters = {{Radio::kBeacon, "a"}, {Radio::kBeacon, "b"}};
  for (const std::int64_t ms : {100, 400, 999, 1000, 2999}) {
    evidence.readings.push_back({Ms(ms), Ms(ms), static_cast<std::uint32_t>(ms % 2), -60});
  }
  const std::vector<Sweep> sweeps = GroupSweeps(evidence, Radio::kBeacon);
  ASSERT_EQ(sweeps.size(), 3U);
  EXPECT_EQ(sweeps[0].readings, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(sweeps[1].readings, (std::vector<std::size_t>{3}));
  EXPECT_TRUE(GroupSweeps(evidence, Radio::kWifi).empty());
}

// A clock that counts from the recording's own start may run through zero.
TEST(GroupSweepsTest, SecondsBeforeZeroAreSecondsToo) {
  Evidence evidence;
  evidence.transmitters = {{Radio::kBeacon, "a"}};
  for (const TimeNs ms : {-900, 900}) {
    evidence.readings.push_back({ms * kNsPerMs, ms * kNsPerMs, 0, -60});
  }
  EXPECT_EQ(GroupSweeps(evidence, Radio::kBeacon).size(), 2U);
}

TEST(GroupSweepsTest, OrderIsByMeanTimeHeard) {
  Evidence evidence;
  evidence.transmitters = {{Radio::kWifi, "a"}};
  // Printed last but heard first; a hundred readings whose times add up to more
  // than 64 bits hold.
  evidence.readings.push_back({Ms(0), Ms(9'000), 0, -60});
  for (int i = 0; i < 100; ++i) evidence.readings.push_back({Ms(4'000 + i), Ms(8'000), 0, -60});
  const std::vector<Sweep> sweeps = GroupSweeps(evidence, Radio::kWifi);
  ASSERT_EQ(sweeps.size(), 2U);
  EXPECT_EQ(sweeps[0].mean_heard_ns, Ms(0));
  EXPECT_EQ(sweeps[1].mean_heard_ns, Ms(4'049) + kNsPerMs / 2);
}

TEST(GroupSweepsTest, ReadingsOfASweepStayInOrderOfTime) {
  const Evidence evidence = RandomReadings(3);
  TimeNs last = 0;
  for (const Sweep& sweep : GroupSweeps(evidence, Radio::kWifi)) {
    EXPECT_TRUE(std::is_sorted(sweep.readings.begin(), sweep.readings.end()));
    EXPECT_GE(sweep.mean_heard_ns, last);
    last = sweep.mean_heard_ns;
  }
}

}  // namespace
}  // namespace walkgraph
