#ifndef WALKGRAPH_EVAL_STATISTICS_RANK_TEST_H_
#define WALKGRAPH_EVAL_STATISTICS_RANK_TEST_H_

#include <limits>
#include <vector>

namespace walkgraph {

// The signed-rank test of paired differences (Wilcoxon 1945, Individual comparisons by ranking
// methods, Biometrics Bulletin 1).
struct SignedRankTest {
  int n = 0;          // pairs that differ; ties of a pair are left out, as Wilcoxon does
  double w_plus = 0;  // sum of the ranks of |difference| over the positive differences
  double p_value = std::numeric_limits<double>::quiet_NaN();  // two-sided; NaN without pairs
};

// Up to this many pairs the distribution of W+ is counted out, above it is taken as normal.
inline constexpr int kExactSignedRankPairs = 50;

// Equal magnitudes share their mean rank. The exact distribution is that given those ranks; the
// normal one has its variance, without correction for continuity.
SignedRankTest TestSignedRanks(const std::vector<double>& differences);

// The p-values corrected for their number by Holm's step-down method (Holm 1979, Scandinavian
// Journal of Statistics 6), in the order given. NaN is no test: it stays NaN and is not counted.
std::vector<double> HolmCorrected(const std::vector<double>& p_values);

// The rank of each value from 1, equal values with their mean rank.
std::vector<double> MidRanks(const std::vector<double>& values);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_STATISTICS_RANK_TEST_H_
