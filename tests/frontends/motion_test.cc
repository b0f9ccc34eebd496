#include "frontends/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "data/angle.h"
#include "frontends/build_evidence.h"
#include "frontends/synthetic_walk.h"

namespace walkgraph {
namespace {

void ExpectTiles(const Evidence& evidence) {
  ASSERT_FALSE(evidence.motion.empty());
  EXPECT_EQ(evidence.motion.front().begin_ns, evidence.begin_ns);
  EXPECT_EQ(evidence.motion.back().end_ns, evidence.end_ns);
  for (std::size_t i = 0; i < evidence.motion.size(); ++i) {
    EXPECT_LT(evidence.motion[i].begin_ns, evidence.motion[i].end_ns);
    if (i == 0) continue;
    EXPECT_EQ(evidence.motion[i].begin_ns, evidence.motion[i - 1].end_ns);
    EXPECT_NE(evidence.motion[i].state, evidence.motion[i - 1].state);
  }
}

// The walk with its first seconds replaced by turning the phone over and over, once a second, in a
// hand that also shakes it.
Recording WithWavingFirst(Recording recording, double seconds) {
  for (std::size_t i = 0; i < recording.accelerometer_mps2.size(); ++i) {
    const double t = SecondsBetween(recording.begin_ns, recording.accelerometer_mps2.time_ns[i]);
    if (t > seconds) break;
    const double rate = 2 * std::numbers::pi;
    const Eigen::Quaterniond to_device = Turn(-rate * t, Eigen::Vector3d(1, 1, 0).normalized());
    const double shake = 3 * std::sin(2 * std::numbers::pi * 1.7 * t);
    recording.accelerometer_mps2.value[i] =
        to_device * Eigen::Vector3d(0, 0, kStandardGravityMps2 + shake);
    recording.gyroscope_radps.value[i] = rate * Eigen::Vector3d(1, 1, 0).normalized();
  }
  return recording;
}

TEST(Motion, StandWalkStand) {
  const Evidence evidence = BuildEvidence(Simulate({.stand_s = 5}), {});
  ExpectTiles(evidence);
  ASSERT_EQ(evidence.motion.size(), 3u);
  EXPECT_EQ(evidence.motion[0].state, MotionState::kStanding);
  EXPECT_EQ(evidence.motion[1].state, MotionState::kWalking);
  EXPECT_EQ(evidence.motion[2].state, MotionState::kStanding);
  EXPECT_NEAR(SecondsBetween(evidence.begin_ns, evidence.motion[1].begin_ns), 5, 0.3);
  EXPECT_NEAR(SecondsBetween(evidence.motion[1].end_ns, evidence.end_ns), 5, 0.3);
}

TEST(Motion, WavingThePhoneIsHandlingAndYieldsNoSteps) {
  const SyntheticWalk walk{.stand_s = 30};
  const Evidence evidence = BuildEvidence(WithWavingFirst(Simulate(walk), 20), {});
  ExpectTiles(evidence);
  ASSERT_EQ(evidence.motion.size(), 4u);
  EXPECT_EQ(evidence.motion[0].state, MotionState::kHandling);
  EXPECT_NEAR(SecondsBetween(evidence.begin_ns, evidence.motion[0].end_ns), 20, 2.5);
  EXPECT_EQ(evidence.motion[1].state, MotionState::kStanding);
  EXPECT_EQ(evidence.motion[2].state, MotionState::kWalking);
  EXPECT_EQ(evidence.steps.size(), 20u);
  EXPECT_GT(evidence.steps.front().begin_ns, kSyntheticBeginNs + 29 * kNsPerSecond);
  EXPECT_GT(evidence.counts.at("step_while_handling"), 10);
}

TEST(Motion, AnArmSwingingByTenDegreesIsNotHandling) {
  Recording recording = Simulate({.steps = 40});
  for (std::size_t i = 0; i < recording.accelerometer_mps2.size(); ++i) {
    const double t = SecondsBetween(recording.begin_ns, recording.accelerometer_mps2.time_ns[i]);
    const double swing_rad = 0.17 * std::sin(2 * std::numbers::pi * 0.9 * t);
    const double rate_radps =
        0.17 * 2 * std::numbers::pi * 0.9 * std::cos(2 * std::numbers::pi * 0.9 * t);
    recording.accelerometer_mps2.value[i] =
        Turn(-swing_rad, Eigen::Vector3d::UnitX()) * recording.accelerometer_mps2.value[i];
    recording.gyroscope_radps.value[i] = Eigen::Vector3d(rate_radps, 0, 0);
  }
  const Evidence evidence = BuildEvidence(recording, {});
  EXPECT_EQ(evidence.steps.size(), 40u);
  for (const MotionInterval& interval : evidence.motion) {
    EXPECT_NE(interval.state, MotionState::kHandling);
  }
}

// The yaw of a walk replaced; its vertical acceleration stays.
Evidence WithYawRate(const std::function<double(double)>& rate_radps) {
  Recording recording = Simulate({.stand_s = 5, .steps = 40});
  for (std::size_t i = 0; i < recording.gyroscope_radps.size(); ++i) {
    const double t = SecondsBetween(recording.begin_ns, recording.gyroscope_radps.time_ns[i]);
    recording.gyroscope_radps.value[i] = Eigen::Vector3d(0, 0, rate_radps(t));
  }
  return BuildEvidence(recording, {});
}

TEST(Motion, SwayingThePhoneAboutTheVerticalIsHandling) {
  const double omega = 2 * std::numbers::pi * 0.8;
  const Evidence evidence = WithYawRate([&](double t) {
    return t > 8 && t < 18 ? DegreesToRadians(30) * omega * std::cos(omega * t) : 0.0;
  });
  ExpectTiles(evidence);
  double handled_s = 0;
  for (const MotionInterval& interval : evidence.motion) {
    if (interval.state != MotionState::kHandling) continue;
    handled_s += SecondsBetween(interval.begin_ns, interval.end_ns);
  }
  EXPECT_NEAR(handled_s, 10, 2);
}

TEST(Motion, SharpTurnsOfTheWalkerAreNotHandling) {
  // A right angle within half a second, every 4 s, and once a turn back on the spot.
  const Evidence evidence = WithYawRate([](double t) {
    if (t > 20 && t < 21) return std::numbers::pi;
    return std::fmod(t, 4.0) < 0.5 ? std::numbers::pi : 0.0;
  });
  EXPECT_EQ(evidence.steps.size(), 40u);
  for (const MotionInterval& interval : evidence.motion) {
    EXPECT_NE(interval.state, MotionState::kHandling);
  }
}

TEST(Motion, CornersInQuickSuccessionAreNotHandling) {
  // A right angle to the left and, a second and a half later, one to the right, again and again;
  // then three to the left with a little swing back after each, as on winding stairs.
  const Evidence evidence = WithYawRate([](double t) {
    if (t > 20 && t < 23) return std::fmod(t, 1.0) < 0.8 ? std::numbers::pi / 1.6 : -1.0;
    const double phase = std::fmod(t, 3.0);
    if (phase < 0.5) return std::numbers::pi;
    return phase >= 1.5 && phase < 2.0 ? -std::numbers::pi : 0.0;
  });
  EXPECT_EQ(evidence.steps.size(), 40u);
  for (const MotionInterval& interval : evidence.motion) {
    EXPECT_NE(interval.state, MotionState::kHandling);
  }
}

TEST(Motion, OverlappingHandlingAndStepsStillTile) {
  const std::vector<TimeSpan> handling = {{10, 20}, {50, 300}};
  const std::vector<StepEvidence> steps = {{.begin_ns = 15, .end_ns = 30, .length_m = 1},
                                           {.begin_ns = 30, .end_ns = 60, .length_m = 1}};
  const auto motion = ClassifyMotion(0, 100, handling, steps);
  TimeNs t = 0;
  for (const MotionInterval& interval : motion) {
    EXPECT_EQ(interval.begin_ns, t);
    EXPECT_GT(interval.end_ns, t);
    t = interval.end_ns;
  }
  EXPECT_EQ(t, 100);
}

}  // namespace
}  // namespace walkgraph
