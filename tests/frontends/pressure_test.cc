#include "frontends/pressure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "frontends/build_evidence.h"
#include "frontends/evidence/barometric_formula.h"

namespace walkgraph {
namespace {

using Counts = std::map<std::string, std::int64_t>;

constexpr TimeNs kInterval = kNsPerSecond / 8;

// A barometer at 8 Hz that rises by `climb_hpa` a sample, written in units of `unit_hpa`.
Recording Rising(int samples, double climb_hpa, double unit_hpa = 1.0) {
  Recording recording;
  recording.end_ns = samples * kInterval;
  for (int i = 0; i < samples; ++i) {
    recording.pressure_hpa.push_back(i * kInterval, (1000.0 + climb_hpa * i) / unit_hpa);
  }
  return recording;
}

TEST(HeightOfPressure, FollowsTheBarometricFormula) {
  EXPECT_NEAR(HeightOfPressure(1000.0), 111.025, 0.001);
  EXPECT_EQ(HeightOfPressure(1013.25), 0.0);
  // Two phones 0.45 hPa apart are a storey apart.
  EXPECT_NEAR(HeightOfPressure(1013.25) - HeightOfPressure(1013.70), 3.75, 0.01);
  EXPECT_NEAR(PressureAtHeight(HeightOfPressure(987.6)), 987.6, 1e-9);
  // One temperature: the same ratio of pressures is the same height anywhere.
  EXPECT_NEAR(HeightOfPressure(800) - HeightOfPressure(1000),
              HeightOfPressure(640) - HeightOfPressure(800), 1e-9);
}

TEST(Pressure, AnyUnitGivesTheSameHeights) {
  Counts in_hpa, in_pa, in_kpa;
  const HeightStream hpa = BarometricHeight(Rising(80, 0.01), {}, &in_hpa);
  const HeightStream pa = BarometricHeight(Rising(80, 0.01, 0.01), {}, &in_pa);
  const HeightStream kpa = BarometricHeight(Rising(80, 0.01, 10.0), {}, &in_kpa);
  ASSERT_EQ(hpa.height_m.size(), 10u);
  ASSERT_EQ(pa.height_m.size(), 10u);
  ASSERT_EQ(kpa.height_m.size(), 10u);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_NEAR(pa.height_m.value[i], hpa.height_m.value[i], 1e-6);
    EXPECT_NEAR(kpa.height_m.value[i], hpa.height_m.value[i], 1e-6);
  }
  EXPECT_TRUE(in_hpa.empty());
  EXPECT_EQ(in_pa, (Counts{{"pressure_in_pa", 80}}));
  EXPECT_EQ(in_kpa, (Counts{{"pressure_in_kpa", 80}}));
}

TEST(Pressure, WhatIsNoPressureInTheStreamsUnitIsDropped) {
  Stream<double> pressure;
  for (const double p : {1013.2, 101320.0, 101.32, 5.0, 299.9, 1100.1, 1012.9}) {
    pressure.push_back(static_cast<TimeNs>(pressure.size()) * kNsPerSecond, p);
  }
  Counts counts;
  const Stream<double> good = CheckPressure(pressure, {}, &counts);
  EXPECT_EQ(good.value, (std::vector<double>{1013.2, 1012.9}));
  EXPECT_EQ(counts, (Counts{{"pressure_out_of_range", 5}}));
}

TEST(Pressure, AStuckSensorIsDroppedAndOneThatSticksLaterFromThenOn) {
  Recording recording = Rising(200, 0.0);
  Counts counts;
  EXPECT_TRUE(BarometricHeight(recording, {}, &counts).height_m.empty());
  EXPECT_EQ(counts.at("pressure_constant"), 200);
  for (std::size_t i = 0; i < 100; ++i) {
    recording.pressure_hpa.value[i] += 0.001 * static_cast<double>(i % 7);
  }
  counts.clear();
  EXPECT_EQ(CheckPressure(recording.pressure_hpa, {}, &counts).size(), 100u);
  EXPECT_EQ(counts.at("pressure_constant"), 100);
}

TEST(Pressure, OneThatStopsIsNamedAndUsedUntilThen) {
  Recording recording = Rising(80, 0.01);
  recording.end_ns += 30 * kNsPerSecond;
  Counts counts;
  EXPECT_EQ(BarometricHeight(recording, {}, &counts).height_m.size(), 10u);
  EXPECT_EQ(counts, (Counts{{"pressure_stopped_s", 30}}));
}

TEST(Pressure, MeansStandAtTheirTimesWithTheirStandardError) {
  // Linear in time, so that a mean is the height at the mean time.
  Counts counts;
  const HeightStream linear = BarometricHeight(Rising(80, 0.001), {}, &counts);
  for (std::size_t i = 0; i < linear.height_m.size(); ++i) {
    const double at = static_cast<double>(linear.height_m.time_ns[i]) / kInterval;
    EXPECT_NEAR(linear.height_m.value[i], HeightOfPressure(1000.0 + 0.001 * at), 1e-4);
  }
  Recording noisy = Rising(80, 0.0);
  for (std::size_t i = 0; i < 80; ++i) noisy.pressure_hpa.value[i] += i % 2 == 0 ? 0.01 : -0.01;
  const HeightStream means = BarometricHeight(noisy, {}, &counts);
  for (std::size_t i = 0; i < means.height_m.size(); ++i) {
    EXPECT_NEAR(means.height_m.value[i], HeightOfPressure(1000.0), 1e-3);
    EXPECT_NEAR(means.sigma_m[i], 0.0845 / std::sqrt(7.0), 1e-3);  // 0.01 hPa, 8 samples
  }
}

TEST(Pressure, EvidenceHoldsHeightsOnly) {
  const Evidence evidence = BuildEvidence(Rising(80, 0.01), {});
  EXPECT_EQ(evidence.barometric_height_m.size(), 10u);
  EXPECT_EQ(evidence.barometric_height_sigma_m.size(), 10u);
}

}  // namespace
}  // namespace walkgraph
