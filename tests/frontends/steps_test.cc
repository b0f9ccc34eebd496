#include "frontends/steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "data/simulator/sample.h"
#include "frontends/build_evidence.h"
#include "frontends/synthetic_walk.h"

namespace walkgraph {
namespace {

// Missed and double steps against the true step spans: the true middle of a step has to lie in
// exactly one detected step.
struct StepErrors {
  int missed = 0;
  int doubled = 0;
};

StepErrors CountStepErrors(const SyntheticWalk& walk, const std::vector<StepEvidence>& steps) {
  StepErrors errors;
  const double period_s = 1 / walk.cadence_hz;
  for (int i = 0; i < walk.steps; ++i) {
    const TimeNs begin = kSyntheticBeginNs + DurationNs(walk.stand_s + i * period_s);
    const TimeNs end = begin + DurationNs(period_s);
    int middles = 0;
    for (const StepEvidence& step : steps) {
      const TimeNs middle = step.begin_ns + (step.end_ns - step.begin_ns) / 2;
      middles += middle >= begin && middle < end;
    }
    errors.missed += middles == 0;
    errors.doubled += middles > 1;
  }
  return errors;
}

class StepDetection : public testing::TestWithParam<std::tuple<double, double, double>> {};

TEST_P(StepDetection, FindsEveryStepOnceAtAnyRateCadenceAndStrength) {
  const auto [rate_hz, cadence_hz, swing_mps2] = GetParam();
  const SyntheticWalk walk{.rate_hz = rate_hz,
                           .cadence_hz = cadence_hz,
                           .steps = 30,
                           .swing_mps2 = swing_mps2,
                           .hold = Turn(0.7, Eigen::Vector3d::UnitX())};
  const Evidence evidence = BuildEvidence(Simulate(walk), {});
  const StepErrors errors = CountStepErrors(walk, evidence.steps);
  EXPECT_EQ(errors.missed, 0);
  EXPECT_EQ(errors.doubled, 0);
  EXPECT_EQ(evidence.steps.size(), 30u);
}

INSTANTIATE_TEST_SUITE_P(RatesCadencesStrengths, StepDetection,
                         testing::Combine(testing::Values(35.0, 50.0, 100.0, 200.0),
                                          testing::Values(1.3, 1.8, 2.3),
                                          testing::Values(2.0, 4.0, 9.0)));

TEST(Steps, TileTheWalkInOrder) {
  const SyntheticWalk walk{.steps = 25};
  const Evidence evidence = BuildEvidence(Simulate(walk), {});
  ASSERT_EQ(evidence.steps.size(), 25u);
  for (std::size_t i = 1; i < evidence.steps.size(); ++i) {
    EXPECT_EQ(evidence.steps[i].begin_ns, evidence.steps[i - 1].end_ns);
  }
  const TimeNs walk_begin_ns = kSyntheticBeginNs + DurationNs(walk.stand_s);
  EXPECT_NEAR(SecondsBetween(walk_begin_ns, evidence.steps.front().begin_ns), 0, 0.2);
  EXPECT_NEAR(SecondsBetween(evidence.steps.front().begin_ns, evidence.steps.back().end_ns),
              walk.walk_s(), 0.3);
}

TEST(Steps, LengthGrowsWithTheFourthRootOfTheSwing) {
  SyntheticWalk walk{.swing_mps2 = 2, .second_bump = 0, .noise_mps2 = 0};
  const Evidence weak = BuildEvidence(Simulate(walk), {});
  walk.swing_mps2 = 8;
  const Evidence strong = BuildEvidence(Simulate(walk), {});
  ASSERT_EQ(weak.steps.size(), strong.steps.size());
  for (std::size_t i = 3; i + 3 < weak.steps.size(); ++i) {
    EXPECT_NEAR(strong.steps[i].length_m / weak.steps[i].length_m, std::sqrt(2.0), 0.03);
  }
}

TEST(Steps, AStandingPersonMakesNone) {
  const SyntheticWalk walk{.stand_s = 30, .steps = 0, .noise_mps2 = 0.3};
  EXPECT_TRUE(BuildEvidence(Simulate(walk), {}).steps.empty());
}

TEST(Steps, ASinglePeakIsNoWalk) {
  const SyntheticWalk walk{.steps = 1, .second_bump = 0};
  const Evidence evidence = BuildEvidence(Simulate(walk), {});
  EXPECT_TRUE(evidence.steps.empty());
  EXPECT_EQ(evidence.counts.at("step_alone"), 1);
}

TEST(Steps, IrregularGaitIsStillCountedToOnePercent) {
  // Cadence and strength wander from step to step.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> interval(0.45, 0.7), swing(2.0, 5.0);
  Stream<double> vertical;
  const int kSteps = 400;
  double t = 0;
  for (int step = 0; step < kSteps; ++step) {
    const double duration = interval(random), amplitude = swing(random) / 2;
    for (double phase = 0; phase < 1; phase += 0.01 / duration, t += 0.01) {
      vertical.push_back(DurationNs(t), -amplitude * std::cos(2 * std::numbers::pi * phase));
    }
  }
  std::map<std::string, std::int64_t> counts;
  const auto steps = DetectSteps(vertical, {}, {}, &counts);
  EXPECT_NEAR(static_cast<double>(steps.size()), kSteps, kSteps / 100.0);
}

// On the sample, where the true heel strikes are known (whole numbers of the step phase): a
// detected step belongs to the strike nearest to its middle.
TEST(Steps, MissesAndDoublesFewOfTheSamplesSteps) {
  std::int64_t strikes = 0, hit = 0, doubled = 0, beyond = 0;
  const std::vector<SimulatedWalk> walks = MakeSample(1).walks;
  for (const SimulatedWalk& walk : walks) {
    Stream<double> phase;
    for (const WalkState& state : walk.path) phase.push_back(state.time_ns, state.step_phase);
    std::map<std::int64_t, int> found;
    for (const StepEvidence& step : BuildEvidence(walk.recording, {}).steps) {
      const TimeNs middle = step.begin_ns + (step.end_ns - step.begin_ns) / 2;
      ++found[std::llround(Interpolate(phase, middle))];
    }
    const auto last = static_cast<std::int64_t>(std::floor(phase.value.back()));
    strikes += last + 1;
    for (const auto& [strike, count] : found) {
      hit += strike <= last;
      beyond += strike > last;
      doubled += count - 1;
    }
  }
  RecordProperty("strikes", std::to_string(strikes));
  RecordProperty("missed", std::to_string(strikes - hit));
  RecordProperty("doubled", std::to_string(doubled));
  RecordProperty("beyond_the_last", std::to_string(beyond));
  ASSERT_GT(strikes, 800);
  EXPECT_LE(strikes - hit, strikes / 100);
  EXPECT_LE(doubled, strikes / 100);
  EXPECT_LE(beyond, static_cast<std::int64_t>(walks.size()));  // stopping may look like one more
}

}  // namespace
}  // namespace walkgraph
