#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "data/simulator/barometer.h"
#include "data/simulator/scenarios.h"
#include "data/simulator/standard_atmosphere.h"

namespace walkgraph {
namespace {

constexpr TimeNs kIntervalNs = 10 * kNsPerMs;

// A person at `height_m` who stands there.
std::vector<WalkState> Standing(double height_m, double duration_s) {
  std::vector<WalkState> states;
  for (TimeNs time_ns = 0; time_ns < DurationNs(duration_s); time_ns += kIntervalNs) {
    WalkState& state = states.emplace_back();
    state.time_ns = time_ns;
    state.height_m = height_m;
  }
  return states;
}

std::vector<double> Pressures(const std::vector<WalkState>& states,
                              const BarometerSettings& settings, std::uint64_t seed = 1) {
  Random random(seed);
  Recording recording;
  SimulateBarometer(states, settings, &random, &recording);
  return recording.pressure_hpa.value;
}

double Mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double Deviation(const std::vector<double>& values) {
  const double mean = Mean(values);
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

TEST(StandardAtmosphere, HasTheTabulatedPressures) {
  // ISO 2533, table 1.
  EXPECT_NEAR(StandardPressure(0), 1013.25, 1e-9);
  EXPECT_NEAR(StandardPressure(1000), 898.746, 0.001);
  EXPECT_NEAR(StandardPressure(5000), 540.199, 0.002);
  for (const double height_m : {-400.0, 0.0, 3.5, 1200.0}) {
    EXPECT_NEAR(StandardHeight(StandardPressure(height_m)), height_m, 1e-8);
  }
}

TEST(Barometer, WithoutDisturbanceMeasuresTheStandardHeight) {
  BarometerSettings settings = CleanSettings().barometer;
  settings.noise_hpa = 0;
  for (const double height_m : {-7.0, 0.0, 3.5, 10.5}) {
    for (const double hpa : Pressures(Standing(height_m, 5), settings)) {
      EXPECT_NEAR(StandardHeight(hpa), height_m, 1e-6);
    }
  }
}

TEST(Barometer, WarmAirMakesStoreysSeemLower) {
  BarometerSettings settings = CleanSettings().barometer;
  settings.noise_hpa = 0;
  settings.air_temperature_k = 295.0;
  const double height_m = StandardHeight(Pressures(Standing(3.5, 1), settings).front());
  EXPECT_NEAR(height_m, 3.5 * 288.15 / 295.0, 1e-6);
}

// Standing phones of ipin2023: 0.0167 hPa in all and 0.0046 hPa from sample to sample.
TEST(Barometer, StandingNoiseIsWhatPhonesShow) {
  BarometerSettings settings;
  settings.trend_sigma_hpa_per_h = 0;
  settings.steps_per_hour = 0;
  double all = 0;
  double fast = 0;
  constexpr int kWalks = 100;
  for (int i = 0; i < kWalks; ++i) {
    const std::vector<double> hpa =
        Pressures(Standing(0, 16), settings, static_cast<std::uint64_t>(i));
    std::vector<double> differences;
    for (std::size_t k = 1; k < hpa.size(); ++k) differences.push_back(hpa[k] - hpa[k - 1]);
    all += Deviation(hpa) / kWalks;
    fast += Deviation(differences) / std::sqrt(2.0) / kWalks;
  }
  EXPECT_NEAR(all, 0.0167, 0.003);
  EXPECT_NEAR(fast, 0.0046, 0.002);
}

// On one floor of ipin2023 seconds a minute apart differ by 0.033 hPa.
TEST(Barometer, DriftsAsMuchInAMinuteAsTheMuseum) {
  BarometerSettings settings;
  settings.steps_per_hour = 0;
  double squares = 0;
  constexpr int kWalks = 200;
  for (int i = 0; i < kWalks; ++i) {
    const std::vector<double> hpa =
        Pressures(Standing(0, 62), settings, static_cast<std::uint64_t>(i));
    const auto second = static_cast<std::ptrdiff_t>(8);
    const double before = Mean({hpa.begin(), hpa.begin() + second});
    const double after = Mean({hpa.end() - second, hpa.end()});
    squares += (after - before) * (after - before) / kWalks;
  }
  EXPECT_NEAR(std::sqrt(squares), 0.033, 0.008);
}

TEST(Barometer, OffsetsOfPhonesHaveTheirSpread) {
  BarometerSettings settings = CleanSettings().barometer;
  settings.offset_sigma_hpa = 0.35;
  std::vector<double> offsets;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    offsets.push_back(Mean(Pressures(Standing(0, 5), settings, seed)) - 1013.25);
  }
  EXPECT_NEAR(Mean(offsets), 0.0, 0.06);
  EXPECT_NEAR(Deviation(offsets), 0.35, 0.04);
}

TEST(Barometer, PressureStepsComeAndGo) {
  BarometerSettings settings = CleanSettings().barometer;
  settings.noise_hpa = 0;
  settings.steps_per_hour = 60;
  settings.step_sigma_hpa = 0.08;
  const std::vector<double> hpa = Pressures(Standing(0, 3600), settings);
  int up = 0;
  int down = 0;
  for (std::size_t i = 1; i < hpa.size(); ++i) {
    const bool now = std::abs(hpa[i] - 1013.25) > 1e-9;
    const bool before = std::abs(hpa[i - 1] - 1013.25) > 1e-9;
    up += now && !before ? 1 : 0;
    down += before && !now ? 1 : 0;
  }
  // Steps begin after a mean of 60 s without one and stay for 20 s: some 45 an hour.
  EXPECT_NEAR(up, 45, 20);
  EXPECT_NEAR(down, up, 1);
}

TEST(Barometer, BreaksInTheWaysThatItIsTold) {
  const std::vector<WalkState> states = Standing(3.5, 60);
  const BarometerSettings works;
  const std::vector<double> hpa = Pressures(states, works);
  BarometerSettings settings = works;
  settings.state = BarometerState::kMissing;
  EXPECT_TRUE(Pressures(states, settings).empty());

  settings.state = BarometerState::kStops;
  const std::vector<double> half = Pressures(states, settings);
  EXPECT_NEAR(static_cast<double>(half.size()), 0.5 * static_cast<double>(hpa.size()), 1.0);
  EXPECT_EQ(half, std::vector<double>(hpa.begin(), hpa.begin() + static_cast<int>(half.size())));

  settings.state = BarometerState::kConstant;
  EXPECT_EQ(Pressures(states, settings), std::vector<double>(hpa.size(), hpa.front()));

  settings = works;
  settings.unit = PressureUnit::kPa;
  EXPECT_NEAR(Pressures(states, settings)[7], 100.0 * hpa[7], 1e-9);
  settings.unit = PressureUnit::kKpa;
  EXPECT_NEAR(Pressures(states, settings)[7], 0.1 * hpa[7], 1e-9);
}

}  // namespace
}  // namespace walkgraph
