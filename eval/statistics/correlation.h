#ifndef WALKGRAPH_EVAL_STATISTICS_CORRELATION_H_
#define WALKGRAPH_EVAL_STATISTICS_CORRELATION_H_

#include <limits>
#include <vector>

namespace walkgraph {

// How an error that a method claims goes with the one it makes.
struct Correlation {
  int n = 0;
  double pearson = std::numeric_limits<double>::quiet_NaN();   // linear
  double spearman = std::numeric_limits<double>::quiet_NaN();  // of the ranks
};

// Pairs with a value that is not finite are left out; NaN where fewer than two remain or one of the
// two does not vary. Precondition: equally long.
Correlation Correlate(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_STATISTICS_CORRELATION_H_
