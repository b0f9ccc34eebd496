#include "eval/bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "eval/random.h"

namespace walkgraph {
namespace {

TEST(Bootstrap, PooledMeanIsOverWaypointsNotWalks) {
  EXPECT_NEAR(PooledMean({{10, 1}, {2, 4}}), 12.0 / 5, 1e-12);
  EXPECT_TRUE(std::isnan(PooledMean({})));
}

TEST(Bootstrap, EqualWalksHaveAnIntervalOfNoWidth) {
  const Interval interval = BootstrapMean({{6, 3}, {6, 3}, {6, 3}});
  EXPECT_NEAR(interval.low, 2, 1e-12);
  EXPECT_NEAR(interval.high, 2, 1e-12);
}

TEST(Bootstrap, OneWalkSaysNothingAboutSpread) {
  EXPECT_TRUE(std::isnan(BootstrapMean({{6, 3}}).low));
  EXPECT_TRUE(std::isnan(BootstrapMean({{6, 3}, {0, 0}}).high));
}

// For many independent walks the interval is that of the central limit theorem, mean +- 1.96
// s/sqrt(n).
TEST(Bootstrap, AgreesWithTheNormalIntervalOfManyWalks) {
  SplitMix64 random(7);
  std::vector<WalkTotal> walks;
  double sum = 0, sum_of_squares = 0;
  constexpr int kWalks = 400;
  for (int i = 0; i < kWalks; ++i) {
    const double value = static_cast<double>(random.Index(1000)) / 100.0;
    walks.push_back({value, 1});
    sum += value;
    sum_of_squares += value * value;
  }
  const double mean = sum / kWalks;
  const double half = 1.96 * std::sqrt((sum_of_squares / kWalks - mean * mean) / kWalks);
  const Interval interval = BootstrapMean(walks);
  EXPECT_NEAR(interval.low, mean - half, 0.15 * half);
  EXPECT_NEAR(interval.high, mean + half, 0.15 * half);
}

// The generator's first numbers, so that a change of platform or code cannot pass unseen (the
// reference values of SplitMix64 for seed 1234567).
TEST(SplitMix64, MatchesItsReference) {
  SplitMix64 random(1234567);
  EXPECT_EQ(random.Next(), 6457827717110365317u);
  EXPECT_EQ(random.Next(), 3203168211198807973u);
  EXPECT_EQ(random.Next(), 9817491932198370423u);
}

TEST(HashText, IsFnv1a) {
  EXPECT_EQ(HashText(""), 0xcbf29ce484222325u);
  EXPECT_EQ(HashText("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(HashText("foobar"), 0x85944171f73967e8u);
  EXPECT_EQ(HashText("bar", HashText("foo")), HashText("foobar"));
}

}  // namespace
}  // namespace walkgraph
