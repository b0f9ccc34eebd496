// Each statistic against closed forms, published tables and independent computations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "eval/statistics/correlation.h"
#include "eval/statistics/rank_test.h"
#include "eval/statistics/shapley.h"

namespace walkgraph {
namespace {

TEST(MidRanks, EqualValuesShareTheirMeanRank) {
  EXPECT_EQ(MidRanks({3, 1, 3, 2, 3}), (std::vector<double>{4, 1, 4, 2, 4}));
  EXPECT_TRUE(MidRanks({}).empty());
}

// All of n differences positive: only one of 2^n sign patterns is as extreme on either side.
TEST(SignedRanks, AllPositiveIsTwoPatternsOfAll) {
  const SignedRankTest test = TestSignedRanks({1, 2, 3, 4, 5, 6});
  EXPECT_EQ(test.n, 6);
  EXPECT_NEAR(test.w_plus, 21, 1e-12);
  EXPECT_NEAR(test.p_value, 2.0 / 64, 1e-12);
}

// Every sign pattern counted one by one, with ties among the magnitudes and a pair that is equal.
TEST(SignedRanks, EqualsTheCountOverAllSignPatterns) {
  const std::vector<double> differences = {0.5, -0.5, 1.5, 2, 0, -2, 2, 3, -0.25, 4, 1};
  const SignedRankTest test = TestSignedRanks(differences);
  ASSERT_EQ(test.n, 10);
  std::vector<double> magnitudes;
  for (const double d : differences) {
    if (d != 0) magnitudes.push_back(std::abs(d));
  }
  const std::vector<double> ranks = MidRanks(magnitudes);
  const double centre = 0.5 * std::accumulate(ranks.begin(), ranks.end(), 0.0);
  int as_extreme = 0;
  for (int signs = 0; signs < 1024; ++signs) {
    double w = 0;
    for (int i = 0; i < 10; ++i) w += (signs >> i & 1) != 0 ? ranks[static_cast<size_t>(i)] : 0;
    as_extreme += std::abs(w - centre) >= std::abs(test.w_plus - centre) - 1e-9 ? 1 : 0;
  }
  EXPECT_NEAR(test.p_value, as_extreme / 1024.0, 1e-12);
}

TEST(SignedRanks, SignsTurnedGiveTheSamePAndNoPairsNone) {
  std::vector<double> differences = {1, -2, 3.5, 4, 0.1, -0.3};
  const double p = TestSignedRanks(differences).p_value;
  for (double& d : differences) d = -d;
  EXPECT_NEAR(TestSignedRanks(differences).p_value, p, 1e-12);
  EXPECT_TRUE(std::isnan(TestSignedRanks({0, 0}).p_value));
}

// Just above the border the normal distribution is close to the exact one, counted here: ways of
// choosing ranks 1..n that add up to w or less.
TEST(SignedRanks, NormalContinuesTheExactDistribution) {
  constexpr std::size_t kN = kExactSignedRankPairs + 1;
  std::vector<double> differences;
  std::size_t w_minus = 0;
  std::vector<double> share(kN * (kN + 1) / 2 + 1, 0.0);  // of the subsets with each sum
  share[0] = 1;
  for (std::size_t rank = 1; rank <= kN; ++rank) {
    const bool negative = rank % 3 == 0;
    differences.push_back(negative ? -static_cast<double>(rank) : static_cast<double>(rank));
    w_minus += negative ? rank : 0;
    for (std::size_t w = share.size(); w-- > 0;) {
      share[w] = 0.5 * (share[w] + (w >= rank ? share[w - rank] : 0.0));
    }
  }
  const auto tail = share.begin() + static_cast<std::ptrdiff_t>(w_minus) + 1;
  EXPECT_NEAR(TestSignedRanks(differences).p_value, 2 * std::accumulate(share.begin(), tail, 0.0),
              2e-3);
}

// Holm's method on four tests: 4 * 0.005, 3 * 0.01, 2 * 0.03, and never below an earlier one.
TEST(Holm, StepsDown) {
  const std::vector<double> corrected = HolmCorrected({0.01, 0.04, 0.03, 0.005});
  EXPECT_NEAR(corrected[3], 0.02, 1e-12);
  EXPECT_NEAR(corrected[0], 0.03, 1e-12);
  EXPECT_NEAR(corrected[2], 0.06, 1e-12);
  EXPECT_NEAR(corrected[1], 0.06, 1e-12);
}

TEST(Holm, MissingTestsAreNotCounted) {
  const std::vector<double> corrected = HolmCorrected({0.01, std::nan(""), 0.9});
  EXPECT_NEAR(corrected[0], 0.02, 1e-12);
  EXPECT_TRUE(std::isnan(corrected[1]));
  EXPECT_NEAR(corrected[2], 0.9, 1e-12);
}

TEST(Correlation, IsOneOnALineAndOfTheRanksOnAnyIncreasingCurve) {
  const std::vector<double> x = {1, 2, 3, 4}, line = {5, 7, 9, 11}, curve = {1, 8, 27, 640};
  EXPECT_NEAR(Correlate(x, line).pearson, 1, 1e-12);
  EXPECT_NEAR(Correlate(x, curve).spearman, 1, 1e-12);
  EXPECT_LT(Correlate(x, curve).pearson, 0.9);
  // By hand: deviations (-1, 0, 1) and (-4/3, 5/3, -1/3): 1 / sqrt(2 * 14/3).
  EXPECT_NEAR(Correlate({1, 2, 3}, {0, 3, 1}).pearson, 1 / std::sqrt(28.0 / 3), 1e-12);
}

TEST(Correlation, LeavesOutWhatIsMissing) {
  const Correlation c = Correlate({1, std::nan(""), 3, 4}, {2, 5, 6, INFINITY});
  EXPECT_EQ(c.n, 2);
  EXPECT_NEAR(c.pearson, 1, 1e-12);
  EXPECT_TRUE(std::isnan(Correlate({1}, {1}).pearson));
}

// The glove game: player 0 has a left glove, 1 and 2 a right one, a pair is worth 1. Known values
// 2/3, 1/6, 1/6.
TEST(Shapley, GloveGame) {
  std::vector<double> values(8, 0.0);
  values[0b011] = values[0b101] = values[0b111] = 1;
  const std::vector<double> shares = ShapleyValues(values, 3);
  EXPECT_NEAR(shares[0], 2.0 / 3, 1e-12);
  EXPECT_NEAR(shares[1], 1.0 / 6, 1e-12);
  EXPECT_NEAR(shares[2], 1.0 / 6, 1e-12);
}

// The definition itself: the marginal contribution averaged over all orders.
TEST(Shapley, EqualsTheMeanOverAllOrders) {
  std::vector<double> values;
  for (int s = 0; s < 16; ++s) values.push_back(std::sin(3.7 * s) + 0.1 * s * s);
  std::vector<double> expected(4, 0.0);
  std::vector<int> order = {0, 1, 2, 3};
  do {
    std::size_t joined = 0;
    for (const int player : order) {
      const std::size_t with = joined | std::size_t{1} << player;
      expected[static_cast<std::size_t>(player)] += (values[with] - values[joined]) / 24;
      joined = with;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  const std::vector<double> shares = ShapleyValues(values, 4);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(shares[i], expected[i], 1e-12);
}

}  // namespace
}  // namespace walkgraph
