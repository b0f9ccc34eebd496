#ifndef WALKGRAPH_EVAL_HONESTY_HONESTY_SCORES_H_
#define WALKGRAPH_EVAL_HONESTY_HONESTY_SCORES_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "data/truth.h"
#include "eval/bootstrap.h"
#include "eval/metrics.h"
#include "solvers/estimator.h"

namespace walkgraph {

// Errors of neighbouring nodes are nearly the same one: scored are waypoints at least this far
// apart, s.
inline constexpr double kScoredEveryS = 20;

// The waypoints nearest to every_s / 2, 3 every_s / 2, ... after the first of all, each once.
Truth ThinTruth(const Truth& truth, double every_s);

// A mean over the scored nodes, with the interval of a bootstrap over walks.
struct MeanWithInterval {
  double mean = 0;
  Interval interval;
};

// Whitened residuals of one factor type, pooled over walks.
struct PooledStatistics {
  std::int64_t count = 0;  // measurements
  int dimension = 0;       // of each
  double sum = 0;          // of squared whitened rows

  void Add(std::int64_t more, int rows, double mean_squared_whitened);
  double MeanSquare() const;
};
using StatisticsByType = std::map<std::string, PooledStatistics>;

// What one method said of its own errors in one walk.
struct WalkHonesty {
  bool has_trajectory = false;
  std::vector<WaypointError> errors;  // at the scored nodes
  std::vector<FactorStatistics> statistics;
  std::vector<FactorStatistics> innovations;  // empty where the method does not tell
  double seconds = 0;                         // wall time
};

// What a method's covariances are worth, over walks.
struct HonestyRow {
  std::string method;
  int walks = 0;  // with a trajectory
  int no_answer = 0;
  int n = 0;  // scored nodes
  MeanWithInterval error_m;
  MeanWithInterval nees_per_dimension;   // 1 where the covariance is right
  double median_nees_per_dimension = 0;  // 0.69 where it is right
  MeanWithInterval coverage50;
  MeanWithInterval coverage95;
  double beyond_999 = 0;  // share outside the 99.9 % ellipse
  double seconds_per_walk = 0;
  StatisticsByType statistics;
  StatisticsByType innovations;  // 1 where expectations and noise are right
};

HonestyRow SummariseHonesty(const std::string& method, const std::vector<WalkHonesty>& walks);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_HONESTY_HONESTY_SCORES_H_
