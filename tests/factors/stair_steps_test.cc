#include "factors/stair_steps.h"

#include <gtest/gtest.h>

namespace walkgraph {
namespace {

constexpr TimeNs kSecondNs = 1'000'000'000;

// A step a second, each as long as it is given.
Evidence Steps(const std::vector<double>& lengths_m) {
  Evidence evidence;
  for (std::size_t i = 0; i < lengths_m.size(); ++i) {
    const auto begin = static_cast<TimeNs>(i) * kSecondNs;
    evidence.steps.push_back({begin, begin + kSecondNs, lengths_m[i]});
  }
  return evidence;
}

std::vector<double> Lengths(const Evidence& evidence) {
  std::vector<double> lengths;
  for (const StepEvidence& step : evidence.steps) lengths.push_back(step.length_m);
  return lengths;
}

const FloorPath kUpstairs({{0, 0, 2 * kSecondNs}, {1, 5 * kSecondNs, 8 * kSecondNs}});

TEST(StairSteps, AreTreadsBetweenLevelsOnly) {
  StepSettings settings;
  settings.tread_m = 0.3;
  Evidence evidence = Steps({0.6, 0.7, 0.7, 0.2, 0.8, 0.6});
  ShortenStairSteps(kUpstairs, settings, &evidence);
  EXPECT_EQ(Lengths(evidence), (std::vector<double>{0.6, 0.7, 0.3, 0.2, 0.3, 0.6}));
}

TEST(StairSteps, AreNoneOnALevelOrWithoutATread) {
  Evidence evidence = Steps({0.6, 0.7, 0.7, 0.2, 0.8, 0.6});
  const std::vector<double> before = Lengths(evidence);
  ShortenStairSteps(FloorPath(0), {}, &evidence);
  EXPECT_EQ(Lengths(evidence), before);
  StepSettings none;
  none.tread_m = 0;
  ShortenStairSteps(kUpstairs, none, &evidence);
  EXPECT_EQ(Lengths(evidence), before);
}

}  // namespace
}  // namespace walkgraph
