#include "frontends/heading.h"

#include <gtest/gtest.h>

#include <numbers>

#include "data/angle.h"
#include "frontends/build_evidence.h"
#include "frontends/synthetic_walk.h"

namespace walkgraph {
namespace {

constexpr double kNorth = std::numbers::pi / 2;

// The walker goes north; however the phone is pitched between flat and upright, that is its
// heading.
class HeldAtPitch : public testing::TestWithParam<double> {};

TEST_P(HeldAtPitch, HeadingIsTheWalkingDirection) {
  const SyntheticWalk walk{.noise_mps2 = 0, .hold = Turn(GetParam(), Eigen::Vector3d::UnitX())};
  Recording recording = Simulate(walk);
  const Evidence by_rotation_vector = BuildEvidence(recording, {});
  for (const double heading : by_rotation_vector.absolute_heading_rad.value) {
    EXPECT_NEAR(heading, kNorth, 1e-9);
  }
  recording.rotation_vector = {};
  const Evidence by_magnetometer = BuildEvidence(recording, {});
  ASSERT_FALSE(by_magnetometer.absolute_heading_rad.empty());
  for (const double heading : by_magnetometer.absolute_heading_rad.value) {
    EXPECT_NEAR(heading, kNorth, 1e-9);
  }
}
INSTANTIATE_TEST_SUITE_P(FlatToUpright, HeldAtPitch,
                         testing::Values(0.0, 0.3, 0.8, 1.2, std::numbers::pi / 2, 1.8));

TEST(Heading, UnwrapsThroughManyTurnsAndAgreesWithTheGyroscope) {
  const SyntheticWalk walk{.steps = 60, .noise_mps2 = 0, .yaw_rate_radps = 0.7};
  Recording recording = Simulate(walk);
  for (int source = 0; source < 2; ++source) {
    const Evidence evidence = BuildEvidence(recording, {});
    const double turned = 0.7 * walk.walk_s();
    ASSERT_GT(turned, 2 * std::numbers::pi);
    const Stream<double>& heading = evidence.absolute_heading_rad;
    EXPECT_NEAR(heading.value.back() - heading.value.front(), turned, 0.02);
    EXPECT_NEAR(evidence.gyro_yaw_rad.value.back(), turned, 0.02);
    recording.rotation_vector = {};  // the second time from the magnetometer
  }
}

TEST(Heading, YawDoesNotDependOnHowThePhoneIsHeld) {
  SyntheticWalk walk{.steps = 40, .noise_mps2 = 0, .yaw_rate_radps = -0.4};
  const double flat = BuildEvidence(Simulate(walk), {}).gyro_yaw_rad.value.back();
  for (const double angle : {0.4, 1.0, 2.5}) {
    walk.hold = Turn(angle, Eigen::Vector3d(1, 2, -1).normalized());
    EXPECT_NEAR(BuildEvidence(Simulate(walk), {}).gyro_yaw_rad.value.back(), flat, 1e-6);
  }
}

TEST(Heading, AMagneticDisturbanceRaisesItsSigma) {
  Recording recording = Simulate({.steps = 60, .noise_mps2 = 0});
  recording.rotation_vector = {};
  const TimeNs begin = kSyntheticBeginNs + 15 * kNsPerSecond;
  const TimeNs end = kSyntheticBeginNs + 18 * kNsPerSecond;
  for (std::size_t i = 0; i < recording.magnetometer_ut.size(); ++i) {
    const TimeNs t = recording.magnetometer_ut.time_ns[i];
    if (t > begin && t < end) recording.magnetometer_ut.value[i].x() += 20;
  }
  const Evidence evidence = BuildEvidence(recording, {});
  ASSERT_EQ(evidence.absolute_heading_sigma_rad.size(), evidence.absolute_heading_rad.size());
  const Stream<double> sigma{.time_ns = evidence.absolute_heading_rad.time_ns,
                             .value = evidence.absolute_heading_sigma_rad};
  EXPECT_LT(Interpolate(sigma, begin - 5 * kNsPerSecond), 0.01);
  EXPECT_GT(Interpolate(sigma, begin), 0.2);
  EXPECT_GT(Interpolate(sigma, end), 0.2);
  EXPECT_LT(Interpolate(sigma, end + 5 * kNsPerSecond), 0.01);
}

TEST(Heading, LandscapeHasNone) {
  const SyntheticWalk walk{.noise_mps2 = 0, .hold = Turn(kNorth, Eigen::Vector3d::UnitY())};
  const Evidence evidence = BuildEvidence(Simulate(walk), {});
  EXPECT_TRUE(evidence.absolute_heading_rad.empty());
  EXPECT_TRUE(evidence.absolute_heading_sigma_rad.empty());
  EXPECT_GT(evidence.counts.at("heading_undefined"), 0);
}

TEST(Heading, MagneticNormAndInclination) {
  const SyntheticWalk walk{.noise_mps2 = 0,
                           .hold = Turn(0.6, Eigen::Vector3d(1, 1, 0).normalized())};
  const Evidence evidence = BuildEvidence(Simulate(walk), {});
  for (const MagneticSample& sample : evidence.magnetic.value) {
    EXPECT_NEAR(sample.norm_ut, 50, 1e-9);
    EXPECT_NEAR(sample.inclination_rad, std::atan2(40, 30), 1e-9);
  }
}

TEST(Yaw, GapsAreBridgedAndCounted) {
  Recording recording = Simulate({.steps = 40, .noise_mps2 = 0, .yaw_rate_radps = 0.5});
  const double whole = BuildEvidence(recording, {}).gyro_yaw_rad.value.back();
  Stream<Eigen::Vector3d> cut;
  for (std::size_t i = 0; i < recording.gyroscope_radps.size(); ++i) {
    if (i >= 400 && i < 430) continue;
    cut.push_back(recording.gyroscope_radps.time_ns[i], recording.gyroscope_radps.value[i]);
  }
  recording.gyroscope_radps = cut;
  const Evidence evidence = BuildEvidence(recording, {});
  EXPECT_EQ(evidence.counts.at("gyroscope_gap"), 1);
  EXPECT_NEAR(evidence.gyro_yaw_rad.value.back(), whole, 1e-3);
}

}  // namespace
}  // namespace walkgraph
