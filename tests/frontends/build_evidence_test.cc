#include "frontends/build_evidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "frontends/synthetic_walk.h"

namespace walkgraph {
namespace {

void ExpectFinite(const Evidence& evidence) {
  for (const StepEvidence& step : evidence.steps) {
    EXPECT_TRUE(std::isfinite(step.length_m));
    EXPECT_LE(step.begin_ns, step.end_ns);
  }
  for (const double v : evidence.gyro_yaw_rad.value) EXPECT_TRUE(std::isfinite(v));
  for (const double v : evidence.absolute_heading_rad.value) EXPECT_TRUE(std::isfinite(v));
  for (const double v : evidence.absolute_heading_sigma_rad) EXPECT_TRUE(std::isfinite(v));
  for (const MagneticSample& v : evidence.magnetic.value) {
    EXPECT_TRUE(std::isfinite(v.norm_ut) && std::isfinite(v.inclination_rad));
  }
}

TEST(BuildEvidence, AnEmptyRecordingGivesEmptyEvidence) {
  const Evidence evidence = BuildEvidence({}, {});
  EXPECT_TRUE(evidence.steps.empty() && evidence.motion.empty() && evidence.readings.empty());
  EXPECT_TRUE(evidence.gyro_yaw_rad.empty() && evidence.absolute_heading_rad.empty());
}

TEST(BuildEvidence, OneSampleOfEverything) {
  Recording recording = Simulate({});
  for (auto* stream :
       {&recording.accelerometer_mps2, &recording.gyroscope_radps, &recording.magnetometer_ut}) {
    stream->time_ns.resize(1);
    stream->value.resize(1);
  }
  recording.rotation_vector.time_ns.resize(1);
  recording.rotation_vector.value.resize(1);
  const Evidence evidence = BuildEvidence(recording, {});
  EXPECT_TRUE(evidence.steps.empty());
  EXPECT_EQ(evidence.gyro_yaw_rad.size(), 1u);
  EXPECT_EQ(evidence.absolute_heading_rad.size(), 1u);
  ExpectFinite(evidence);
}

TEST(BuildEvidence, DegenerateStreamsStayFinite) {
  Recording zero = Simulate({});
  for (auto& v : zero.accelerometer_mps2.value) v.setZero();
  for (auto& v : zero.magnetometer_ut.value) v.setZero();
  ExpectFinite(BuildEvidence(zero, {}));
  zero.rotation_vector = {};
  ExpectFinite(BuildEvidence(zero, {}));

  Recording same_time = Simulate({});
  for (auto& t : same_time.accelerometer_mps2.time_ns) t = same_time.begin_ns;
  for (auto& t : same_time.gyroscope_radps.time_ns) t = same_time.begin_ns;
  for (auto& t : same_time.magnetometer_ut.time_ns) t = same_time.begin_ns;
  for (auto& t : same_time.rotation_vector.time_ns) t = same_time.begin_ns;
  same_time.end_ns = same_time.begin_ns;
  ExpectFinite(BuildEvidence(same_time, {}));

  Recording huge = Simulate({});
  for (auto& v : huge.accelerometer_mps2.value) v *= 1e6;
  for (auto& v : huge.gyroscope_radps.value) v.setConstant(1e3);
  ExpectFinite(BuildEvidence(huge, {}));
}

TEST(BuildEvidence, WithoutASensorItsEvidenceIsEmptyAndTheRestIsThere) {
  Recording no_gyroscope = Simulate({});
  no_gyroscope.gyroscope_radps = {};
  const Evidence a = BuildEvidence(no_gyroscope, {});
  EXPECT_TRUE(a.gyro_yaw_rad.empty());
  EXPECT_EQ(a.steps.size(), 20u);
  EXPECT_EQ(a.absolute_heading_sigma_rad.size(), a.absolute_heading_rad.size());

  Recording no_accelerometer = Simulate({});
  no_accelerometer.accelerometer_mps2 = {};
  const Evidence b = BuildEvidence(no_accelerometer, {});
  EXPECT_TRUE(b.steps.empty() && b.motion.empty() && b.gyro_yaw_rad.empty());
  EXPECT_FALSE(b.absolute_heading_rad.empty());
}

TEST(BuildEvidence, MovingTheClockMovesAllTimesAndNothingElse) {
  Recording recording = Simulate({.yaw_rate_radps = 0.2});
  const Evidence before = BuildEvidence(recording, {});
  const TimeNs shift = 123'456'789'012;
  recording.begin_ns += shift;
  recording.end_ns += shift;
  for (auto* stream :
       {&recording.accelerometer_mps2, &recording.gyroscope_radps, &recording.magnetometer_ut}) {
    for (TimeNs& t : stream->time_ns) t += shift;
  }
  for (TimeNs& t : recording.rotation_vector.time_ns) t += shift;
  const Evidence after = BuildEvidence(recording, {});
  ASSERT_EQ(after.steps.size(), before.steps.size());
  for (std::size_t i = 0; i < after.steps.size(); ++i) {
    EXPECT_EQ(after.steps[i].begin_ns, before.steps[i].begin_ns + shift);
    EXPECT_EQ(after.steps[i].length_m, before.steps[i].length_m);
  }
  EXPECT_EQ(after.gyro_yaw_rad.value, before.gyro_yaw_rad.value);
  EXPECT_EQ(after.absolute_heading_rad.value, before.absolute_heading_rad.value);
}

}  // namespace
}  // namespace walkgraph
