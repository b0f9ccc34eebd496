#include "frontends/step_confirmation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "frontends/build_evidence.h"
#include "frontends/synthetic_walk.h"

namespace walkgraph {
namespace {

// Steps of a frequency with a second harmonic, sampled unevenly.
Stream<double> Gait(double hz, double duration_s) {
  Stream<double> gait;
  for (double t = 0; t < duration_s; t += 0.018 + 0.006 * std::sin(7 * t)) {
    const double phase = 2 * std::numbers::pi * hz * t;
    gait.push_back(DurationNs(t), 2 * std::cos(phase) + 0.8 * std::sin(2 * phase));
  }
  return gait;
}

StepPeak PeakAt(double time_s, double value = 2) {
  StepPeak peak;
  peak.time_ns = DurationNs(time_s);
  peak.valley_before_ns = DurationNs(time_s - 0.25);
  peak.valley_after_ns = DurationNs(time_s + 0.25);
  peak.value = value;
  peak.lowest_valley = -2;
  return peak;
}

TEST(WalkingFrequency, IsThatOfTheSteps) {
  for (const double hz : {1.21, 1.5, 1.83, 2.4}) {
    const std::optional<double> found = WalkingFrequency(Gait(hz, 6), 0, DurationNs(6));
    ASSERT_TRUE(found.has_value()) << hz;
    EXPECT_NEAR(*found, hz, 0.03) << hz;
  }
}

TEST(WalkingFrequency, IsUnknownOfAMomentAndOfNothing) {
  EXPECT_FALSE(WalkingFrequency(Gait(1.8, 6), 0, DurationNs(1)).has_value());
  EXPECT_FALSE(WalkingFrequency({}, 0, DurationNs(5)).has_value());
  Stream<double> still;
  for (int i = 0; i < 300; ++i) still.push_back(DurationNs(0.02 * i), 0.0);
  EXPECT_FALSE(WalkingFrequency(still, 0, DurationNs(6)).has_value());
}

TEST(ConfirmByFrequency, CountsFrequencyTimesMovingTime) {
  constexpr double kHz = 2.0;
  const Stream<double> gait = Gait(kHz, 12);
  std::vector<StepPeak> peaks;
  for (int i = 2; i < 22; ++i) {
    if (i == 8 || i == 14 || i == 15) continue;  // missed
    peaks.push_back(PeakAt(i / kHz));
    if (i == 11) peaks.push_back(PeakAt(i / kHz + 0.2, 1));  // a second bump
  }
  std::map<std::string, std::int64_t> counts;
  const std::vector<StepPeak> confirmed = ConfirmByFrequency(gait, peaks, {}, &counts);
  ASSERT_EQ(confirmed.size(), 20U);
  for (int i = 2; i < 22; ++i) {
    EXPECT_NEAR(SecondsBetween(0, confirmed[static_cast<std::size_t>(i - 2)].time_ns), i / kHz,
                0.02);
  }
  EXPECT_EQ(counts["step_unconfirmed"], 1);
  EXPECT_EQ(counts["step_from_frequency"], 3);
}

// A pause is no missed step.
TEST(ConfirmByFrequency, LeavesPausesAlone) {
  const Stream<double> gait = Gait(2.0, 12);
  const std::vector<StepPeak> peaks = {PeakAt(1), PeakAt(1.5), PeakAt(5), PeakAt(5.5)};
  std::map<std::string, std::int64_t> counts;
  EXPECT_EQ(ConfirmByFrequency(gait, peaks, {}, &counts).size(), 4U);
  EXPECT_EQ(counts.size(), 0U);
}

TEST(ConfirmByFrequency, ChangesNoCleanWalk) {
  const Recording recording = Simulate({.steps = 30});
  FrontendSettings settings;
  const Evidence plain = BuildEvidence(recording, settings);
  settings.steps.fourier_confirmation = true;
  const Evidence confirmed = BuildEvidence(recording, settings);
  ASSERT_EQ(confirmed.steps.size(), plain.steps.size());
  for (std::size_t i = 0; i < plain.steps.size(); ++i) {
    EXPECT_EQ(confirmed.steps[i].begin_ns, plain.steps[i].begin_ns);
    EXPECT_EQ(confirmed.steps[i].length_m, plain.steps[i].length_m);
  }
}

}  // namespace
}  // namespace walkgraph
