#ifndef WALKGRAPH_EVAL_SUMMARY_H_
#define WALKGRAPH_EVAL_SUMMARY_H_

#include <map>
#include <string>
#include <vector>

#include "eval/bootstrap.h"
#include "eval/metrics.h"
#include "eval/outcome.h"

namespace walkgraph {

// One line of the table: a method on a selection of waypoints.
struct SummaryRow {
  std::string method;
  int walks = 0;
  ErrorSummary errors;
  Interval mean_interval_m;  // 95 %, bootstrap over walks
};

// One method's mean error minus another's on the same waypoints.
struct PairedDifference {
  std::string method;
  std::string other;
  double mean_m = 0;
  Interval interval_m;  // 95 %, paired bootstrap over walks
};

// A selection of waypoints with a row per method.
struct SummarySection {
  std::string name;  // "pooled", "covered", "floor F1", ...
  std::vector<SummaryRow> rows;
  std::vector<PairedDifference> differences;  // of every ordered pair of methods
};

// The sections, each over waypoints (not over walks' means):
//   pooled     walks on which every method that ran at all gave a trajectory
//   covered    of those, the walks nearer than 3 m to the survey
//   floor X    of those, the waypoints on one floor (floors by increasing number)
//   standing, walking  of those, the waypoints passed in one of these states of motion, where there
//              are waypoints of both
//   trusted    of those, for each method that trusts some of its positions more than others the
//              waypoints at which it does; methods have different ones, so there are no differences
//   all_walks  every walk with waypoints, a missing output scored at the survey's centroid
// Walks that are not finished count nowhere.
std::vector<SummarySection> SummariseEvaluation(const Evaluation& evaluation,
                                                const std::map<int, std::string>& floor_names);

// The sections as text tables; `seconds_per_walk` by method, wall time.
std::string FormatSummary(const std::vector<SummarySection>& sections,
                          const std::map<std::string, double>& seconds_per_walk);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_SUMMARY_H_
