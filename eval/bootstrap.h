#ifndef WALKGRAPH_EVAL_BOOTSTRAP_H_
#define WALKGRAPH_EVAL_BOOTSTRAP_H_

#include <cstdint>
#include <limits>
#include <vector>

namespace walkgraph {

// Something summed over the waypoints of one walk: errors, or differences of two methods' errors.
struct WalkTotal {
  double sum = 0;
  int n = 0;
};

struct Interval {
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
};

inline constexpr int kBootstrapResamples = 2000;
inline constexpr std::uint64_t kBootstrapSeed = 20210;

// 95 % percentile-bootstrap interval of the mean over waypoints, resampling whole walks: the errors
// of one walk are not independent. With totals of differences it is the paired interval of two
// methods. NaN where there are fewer than two walks. The same walks give the same interval.
Interval BootstrapMean(const std::vector<WalkTotal>& walks);

// sum / n over all walks; NaN where n is zero.
double PooledMean(const std::vector<WalkTotal>& walks);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_BOOTSTRAP_H_
