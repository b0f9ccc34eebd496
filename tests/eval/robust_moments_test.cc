#include "eval/calibrate/robust_moments.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "eval/calibrate/leg_comparison.h"

namespace walkgraph {
namespace {

TEST(ClippedMomentsTest, ClosedForms) {
  const Moments moments = ClippedMoments({5, 1, 4, 2, 3});
  EXPECT_DOUBLE_EQ(moments.mean, 3);
  EXPECT_DOUBLE_EQ(moments.variance, 2.5);
  EXPECT_EQ(moments.samples, 5U);
  const Moments one = ClippedMoments({-7});
  EXPECT_EQ(one.mean, -7);
  EXPECT_EQ(one.variance, 0);
  EXPECT_EQ(one.samples, 1U);
  EXPECT_EQ(ClippedMoments({}).samples, 0U);
  const Moments same = ClippedMoments({4, 4, 4, 4});
  EXPECT_EQ(same.mean, 4);
  EXPECT_EQ(same.variance, 0);
}

TEST(ClippedMomentsTest, OutliersDoNotCount) {
  const Moments moments = ClippedMoments({1, 2, 3, 4, 5, 1000, -800});
  EXPECT_DOUBLE_EQ(moments.mean, 3);
  EXPECT_DOUBLE_EQ(moments.variance, 2.5);
  EXPECT_EQ(moments.samples, 5U);
}

// Also where the mean is a billion times the spread.
TEST(ClippedMomentsTest, ShiftsAndScalesWithTheValues) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> values, moved;
  for (int i = 0; i < 501; ++i) {
    values.push_back(normal(random));
    moved.push_back(1e9 + 2 * values.back());
  }
  const Moments a = ClippedMoments(values), b = ClippedMoments(moved);
  EXPECT_EQ(a.samples, b.samples);
  EXPECT_NEAR(b.mean, 1e9 + 2 * a.mean, 1e-6);
  EXPECT_NEAR(b.variance, 4 * a.variance, 1e-5);
}

// A normal density cut off at three sigmas has 0.9733 of its variance.
TEST(ClippedMomentsTest, OfANormalDensityLosesThreePercent) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal(5, 3);
  std::vector<double> values(40'000);
  for (double& value : values) value = normal(random);
  const Moments moments = ClippedMoments(values);
  EXPECT_NEAR(moments.mean, 5, 4 * 3 / 200.0);
  EXPECT_NEAR(moments.variance / 9, 0.9733, 0.03);
}

// Where all errors are alike the likelihood has a closed form: their variance is what the values'
// own exceeds theirs by.
TEST(RandomEffectsTest, ClosedFormOfEqualErrors) {
  const std::vector<double> values{1, 2, 3, 4, 5};
  const Moments exact = RandomEffects(values, std::vector<double>(5, 0.0));
  EXPECT_NEAR(exact.mean, 3, 1e-9);
  EXPECT_NEAR(exact.variance, 2.0, 1e-5);
  EXPECT_NEAR(RandomEffects(values, std::vector<double>(5, 0.5)).variance, 1.5, 1e-5);
  // Errors explain everything: what is left is the standard error, sqrt(2 / 5) times theirs.
  EXPECT_NEAR(RandomEffects(values, std::vector<double>(5, 2.5)).variance, 2.5 * std::sqrt(0.4),
              1e-9);
  EXPECT_EQ(RandomEffects({}, {}).samples, 0U);
}

// 5000 values whose errors go from a third to three times their spread, one in a hundred spoilt.
TEST(RandomEffectsTest, FindsTheSpreadBehindUnequalErrors) {
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> sigma(0.02, 0.15);
  std::vector<double> values, variances;
  for (int i = 0; i < 5000; ++i) {
    const double error = sigma(random);
    variances.push_back(error * error);
    values.push_back(0.3 + 0.05 * normal(random) + error * normal(random));
    if (i % 100 == 0) values.back() = 20;
  }
  const Moments moments = RandomEffects(values, variances);
  EXPECT_NEAR(moments.mean, 0.3, 0.005);
  EXPECT_NEAR(std::sqrt(moments.variance), 0.05, 0.003);
  EXPECT_GT(std::sqrt(ClippedMoments(values).variance), 0.09);
}

// Differences whose squares lie exactly on a line, of either sign.
TEST(VarianceOverLagTest, FindsAnExactLine) {
  std::vector<double> differences, lags;
  for (int i = 1; i <= 20; ++i) {
    lags.push_back(i);
    differences.push_back((i % 2 == 0 ? 1 : -1) * std::sqrt(0.5 + 0.02 * i));
  }
  const Line line = VarianceOverLag(differences, lags);
  EXPECT_NEAR(line.intercept, 0.5, 1e-12);
  EXPECT_NEAR(line.slope, 0.02, 1e-12);
}

TEST(VarianceOverLagTest, StaysInItsQuadrant) {
  const Line falling = VarianceOverLag({2, 1.5, 1}, {1, 2, 3});
  EXPECT_EQ(falling.slope, 0);
  EXPECT_NEAR(falling.intercept, (4 + 2.25 + 1) / 3, 1e-12);
  // Through the origin by least squares: sum xy / sum xx.
  const Line steep = VarianceOverLag({1, 2, 3}, {1, 2, 3});
  EXPECT_EQ(steep.intercept, 0);
  EXPECT_NEAR(steep.slope, (1 + 8 + 27) / 14.0, 1e-12);
  const Line same = VarianceOverLag({1, -3, 2}, {5, 5, 5});
  EXPECT_EQ(same.slope, 0);
  EXPECT_NEAR(same.intercept, 14 / 3.0, 1e-12);
  const Line none = VarianceOverLag({}, {});
  EXPECT_EQ(none.intercept, 0);
  EXPECT_EQ(none.slope, 0);
}

TEST(VarianceOverLagTest, FindsTheLineOfNoise) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> lag(0, 40);
  std::vector<double> differences, lags;
  for (int i = 0; i < 50'000; ++i) {
    lags.push_back(lag(random));
    differences.push_back(std::sqrt(0.04 + 0.001 * lags.back()) * normal(random));
    if (i % 100 == 0) differences.back() = 50;
  }
  const Line line = VarianceOverLag(differences, lags);
  EXPECT_NEAR(line.intercept, 0.04, 0.006);
  EXPECT_NEAR(line.slope, 0.001, 0.0003);
}

WalkLegs LegsOf(const std::vector<double>& headings) {
  WalkLegs legs;
  for (std::size_t i = 0; i < headings.size(); ++i) {
    Leg leg;
    leg.middle_ns = static_cast<TimeNs>(i) * 15 * kNsPerSecond;
    leg.length_m = 10;
    leg.heading_rad = headings[i];
    leg.steps = 14;
    legs.push_back(leg);
  }
  return legs;
}

TEST(LegComparisonTest, MeansOfAnglesAreCircular) {
  const WalkLegs legs = LegsOf({3.1, -3.1});
  EXPECT_NEAR(std::abs(WalkMean(legs, &Leg::heading_rad, true)), std::acos(-1.0), 1e-12);
  EXPECT_NEAR(WalkMean(legs, &Leg::heading_rad, false), 0.0, 1e-12);
}

TEST(LegComparisonTest, LongLegsWeighMore) {
  WalkLegs legs = LegsOf({0.0, 1.0});
  legs[1].length_m = 30;
  EXPECT_NEAR(WalkMean(legs, &Leg::heading_rad, false), 0.9, 1e-12);
}

// Along a straight way the waypoints between legs cancel; round corners they do not. Each step errs
// on its own.
TEST(LegComparisonTest, WaypointsBetweenLegsCancelStraightAhead) {
  WalkLegs legs = LegsOf({0, 0, 0});
  for (Leg& leg : legs) leg.duration_s = 15;
  EXPECT_NEAR(VarianceOfWalkMean(legs, {0.5, 0, 0, 1}), 0.5 / (30.0 * 30.0), 1e-12);
  EXPECT_NEAR(VarianceOfWalkMean(legs, {0, 0.01, 0, 1}), 3 * 14 * 0.01 / (30.0 * 30.0), 1e-12);
  EXPECT_NEAR(VarianceOfWalkMean(legs, {0, 0, 0.01, 5}), 0.01 / 9, 1e-12);
  legs[1].direction_rad = std::acos(-1.0) / 2;
  EXPECT_NEAR(VarianceOfWalkMean(legs, {0.5, 0, 0, 1}), 3 * 0.5 / (30.0 * 30.0), 1e-12);
  for (Leg& leg : legs) leg.duration_s = 10;  // legs left out between
  legs[1].direction_rad = 0;
  EXPECT_NEAR(VarianceOfWalkMean(legs, {0.5, 0, 0, 1}), 3 * 0.5 / (30.0 * 30.0), 1e-12);
}

TEST(LegComparisonTest, PairsAreThoseWithinFortySeconds) {
  const PairDifferences pairs = DifferencesWithinWalks(
      {LegsOf({3.0, -3.0, 0.0, 0.1}), LegsOf({1.0})}, &Leg::heading_rad, true);
  // 0-1, 0-2, 1-2, 1-3, 2-3, but not 0-3, 45 s apart.
  ASSERT_EQ(pairs.difference.size(), 5U);
  EXPECT_NEAR(pairs.difference[0], 2 * std::acos(-1.0) - 6, 1e-12);
  EXPECT_NEAR(pairs.lag_s[1], 30, 1e-9);
}

// The mean that the legs themselves make hides part of their error; what is left over is raised to
// the variance of a leg's own.
TEST(LegComparisonTest, DeviationsHaveTheVarianceOfTheLegs) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal(0, 0.05);
  std::vector<WalkLegs> walks;
  for (int i = 0; i < 4000; ++i)
    walks.push_back(LegsOf({normal(random), normal(random), normal(random)}));
  walks.push_back(LegsOf({9.0, 8.0}));  // too few legs for a mean
  const LegDeviations deviations = DeviationsFromWalk(walks, &Leg::heading_rad, true);
  ASSERT_EQ(deviations.deviation_m.size(), 12'000U);
  double squares = 0;
  for (const double deviation : deviations.deviation_m) squares += deviation * deviation;
  EXPECT_NEAR(squares / 12'000, std::pow(10 * 0.05, 2), 0.01);
  EXPECT_EQ(deviations.steps.front(), 14);
}

// A leg's error and half of each neighbour's make its deviation; the sum is brought back to the
// variance of one leg's end.
TEST(LegComparisonTest, DeviationsFromNeighboursToo) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal(0, 0.05);
  std::vector<WalkLegs> walks;
  for (int i = 0; i < 12'000; ++i)
    walks.push_back(LegsOf({normal(random), normal(random), normal(random)}));
  walks.push_back(LegsOf({9.0, 8.0}));  // too few legs for neighbours
  const LegDeviations deviations = DeviationsFromNeighbours(walks, &Leg::heading_rad, true);
  ASSERT_EQ(deviations.deviation_m.size(), 12'000U);
  double squares = 0;
  for (const double deviation : deviations.deviation_m) squares += deviation * deviation;
  EXPECT_NEAR(squares / 12'000, std::pow(10 * 0.05, 2), 0.01);
  EXPECT_NEAR(deviations.steps.front(), 14, 1e-9);
}

TEST(LegComparisonTest, SteadyDriftIsNoDeviation) {
  const LegDeviations deviations = DeviationsFromNeighbours(
      {LegsOf({2.9, 3.1, 3.3 - 2 * std::acos(-1.0)})}, &Leg::heading_rad, true);
  ASSERT_EQ(deviations.deviation_m.size(), 1U);
  EXPECT_NEAR(deviations.deviation_m[0], 0, 1e-12);
}

// Means of a random walk over legs that follow each other, of 12, 8 and 20 s.
TEST(LegComparisonTest, WanderIsThatOfARandomWalk) {
  constexpr double kStepS = 0.1, kRate = 0.02 * 0.02;
  constexpr std::array kSeconds{12, 8, 20};
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, std::sqrt(kRate * kStepS));
  std::vector<WalkLegs> walks;
  for (int i = 0; i < 4000; ++i) {
    WalkLegs legs = LegsOf({0, 0, 0});
    double value = 0, begin_s = 0;
    for (std::size_t leg = 0; leg < legs.size(); ++leg) {
      const int steps = static_cast<int>(kSeconds[leg] / kStepS);
      for (int k = 0; k < steps; ++k) legs[leg].heading_rad += (value += normal(random)) / steps;
      legs[leg].duration_s = kSeconds[leg];
      legs[leg].middle_ns = DurationNs(begin_s + kSeconds[leg] / 2.0);
      begin_s += kSeconds[leg];
    }
    walks.push_back(legs);
  }
  const LegDeviations deviations = DeviationsFromNeighbours(walks, &Leg::heading_rad, true);
  double squares = 0;
  for (const double deviation : deviations.deviation_m) squares += deviation * deviation;
  EXPECT_NEAR(squares / 4000 / (kRate * deviations.wander.front()), 1.0, 0.08);
}

TEST(VarianceComponentsTest, TellsExactComponentsApart) {
  std::vector<double> differences, ones, steps, wander;
  for (int i = 1; i <= 50; ++i) {
    ones.push_back(1);
    steps.push_back(i % 7);
    wander.push_back(i);
    differences.push_back(std::sqrt(2.0 + 0.5 * steps.back() + 0.1 * wander.back()));
  }
  const std::vector<double> found = VarianceComponents(differences, {ones, steps, wander});
  EXPECT_NEAR(found[0], 2.0, 1e-9);
  EXPECT_NEAR(found[1], 0.5, 1e-9);
  EXPECT_NEAR(found[2], 0.1, 1e-9);
  // What would be negative is left out, and the others fitted without it.
  std::vector<double> falling;
  for (const double lag : wander) falling.push_back(60 - lag);
  const std::vector<double> positive = VarianceComponents(differences, {falling, wander});
  for (const double component : positive) EXPECT_GE(component, 0.0);
  EXPECT_GT(positive[0] + positive[1], 0.0);
}

// Variances from 1 to 1001, with one value in fifty that belongs to none of them: what is clipped
// by one width loses the great variances, what is clipped by each one's own does not.
TEST(RelativeVarianceComponentsTest, KeepsWhatHasTheGreatestVariances) {
  constexpr double kNoise = 1.0, kRate = 0.001;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> differences, ones, cubes;
  for (int i = 0; i < 20000; ++i) {
    ones.push_back(1);
    cubes.push_back(std::pow(i % 100, 3));
    const double sigma = std::sqrt(kNoise + kRate * cubes.back());
    differences.push_back(sigma * (i % 50 == 7 ? 30.0 : normal(random)));
  }
  const std::vector<double> found = RelativeVarianceComponents(differences, {ones, cubes});
  EXPECT_NEAR(found[0], kNoise, 0.1);
  EXPECT_NEAR(found[1], kRate, 0.1 * kRate);
  EXPECT_LT(VarianceComponents(differences, {ones, cubes})[1], 0.7 * kRate);
  EXPECT_EQ(RelativeVarianceComponents({}, {{}, {}}), std::vector<double>(2, 0.0));
}

}  // namespace
}  // namespace walkgraph
