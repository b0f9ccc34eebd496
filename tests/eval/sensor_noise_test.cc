#include "eval/calibrate/sensor_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <random>
#include <vector>

namespace walkgraph {
namespace {

constexpr TimeNs kStart = 1'560'000'000 * kNsPerSecond;

class Walks {
 public:
  explicit Walks(std::uint32_t seed = 1) : random_(seed) {}

  Evidence& Add(double seconds) {
    Evidence& evidence = evidence_.emplace_back();
    evidence.begin_ns = kStart;
    evidence.end_ns = kStart + DurationNs(seconds);
    truth_.emplace_back();
    return evidence;
  }
  Truth& truth() { return truth_.back(); }
  double Normal(double sigma) { return sigma * normal_(random_); }
  std::vector<CalibrationWalk> all() const {
    std::vector<CalibrationWalk> walks;
    for (std::size_t i = 0; i < evidence_.size(); ++i) {
      walks.push_back({&evidence_[i], &truth_[i]});
    }
    return walks;
  }

 private:
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  std::deque<Evidence> evidence_;
  std::deque<Truth> truth_;
};

struct Barometer {
  double sigma_m = 0.2, walk_m_per_sqrt_s = 0.02;
  double own_sigma_m = 0;  // as the evidence has it
};

// Two minutes on a floor, one on the stairs, two on the next.
void AddClimb(const Barometer& barometer, Walks* walks) {
  Evidence& evidence = walks->Add(300);
  double offset = 50;
  for (int t = 0; t <= 300; ++t) {
    const double height = t < 120 ? 0.0 : t < 180 ? 4.0 * (t - 120) / 60 : 4.0;
    offset += walks->Normal(barometer.walk_m_per_sqrt_s);
    evidence.barometric_height_m.push_back(kStart + DurationNs(t),
                                           height + offset + walks->Normal(barometer.sigma_m));
    evidence.barometric_height_sigma_m.push_back(barometer.own_sigma_m);
  }
  for (const int t : {5, 60, 115}) {
    walks->truth().waypoints.push_back({kStart + DurationNs(t), {0, 0}, 0});
  }
  for (const int t : {185, 240, 295}) {
    walks->truth().waypoints.push_back({kStart + DurationNs(t), {0, 0}, 1});
  }
}

struct BarometerFound {
  BarometricSettings barometer;
  BarometricOffsetSettings offset;
  std::vector<CalibratedValue> values;
};

BarometerFound Calibrate(const Barometer& barometer, int count) {
  Walks walks;
  for (int i = 0; i < count; ++i) AddClimb(barometer, &walks);
  BarometerFound found;
  CalibrateBarometer(walks.all(), &found.barometer, &found.offset, &found.values);
  return found;
}

// The stairs, four metres in a minute, are no drift.
TEST(CalibrateBarometer, TellsNoiseFromDriftAndFromStairs) {
  const BarometerFound found = Calibrate({}, 30);
  EXPECT_EQ(found.values.size(), 2U);
  EXPECT_NEAR(found.barometer.sigma_m, 0.2, 0.02);
  EXPECT_NEAR(found.offset.walk_m_per_sqrt_s, 0.02, 0.006);
}

// A factor adds the evidence's own variance to the setting's.
TEST(CalibrateBarometer, WhatTheEvidenceSaysItselfIsNotSetAgain) {
  EXPECT_NEAR(Calibrate({0.2, 0.02, 0.12}, 30).barometer.sigma_m, 0.16, 0.02);
  EXPECT_EQ(Calibrate({0.2, 0.02, 0.5}, 30).barometer.sigma_m, 0.03);
}

TEST(CalibrateBarometer, FewHeightsKeepTheDefaults) {
  EXPECT_TRUE(Calibrate({}, 4).values.empty());
  Walks walks;
  for (int i = 0; i < 20; ++i) walks.Add(60);
  BarometerFound found;
  CalibrateBarometer(walks.all(), &found.barometer, &found.offset, &found.values);
  EXPECT_TRUE(found.values.empty());
  EXPECT_EQ(found.barometer.sigma_m, BarometricSettings().sigma_m);
}

}  // namespace
}  // namespace walkgraph
