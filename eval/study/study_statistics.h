#ifndef WALKGRAPH_EVAL_STUDY_STUDY_STATISTICS_H_
#define WALKGRAPH_EVAL_STUDY_STUDY_STATISTICS_H_

#include <map>
#include <string>
#include <vector>

#include "eval/bootstrap.h"
#include "eval/metrics.h"
#include "eval/statistics/correlation.h"
#include "eval/statistics/rank_test.h"
#include "eval/study/study_results.h"

namespace walkgraph {

// A cell against the study's reference on the same waypoints; negative is better than it.
struct ComparedWithReference {
  double mean_m = std::numeric_limits<double>::quiet_NaN();  // difference of the mean errors
  Interval interval_m;                                       // 95 %, paired bootstrap over walks
  SignedRankTest test;                                       // of the walks' mean errors
  double corrected_p = std::numeric_limits<double>::quiet_NaN();  // for the section's cells (Holm)
};

// One cell on one selection of waypoints.
struct CellStatistics {
  int walks = 0;
  ErrorSummary errors;
  Interval mean_interval_m;        // 95 %, bootstrap over walks
  ComparedWithReference compared;  // empty for the reference itself
  Correlation claimed;             // of claimed with true error
};

// A selection of waypoints with every cell. Sections, each over waypoints:
//   all      every walk with waypoints; a cell without position is scored at the map's centroid
//   covered  of those, the walks nearer than kCoveredDistanceM to the survey
//   placed   the walks on which every cell has a position
struct StudySection {
  std::string name;
  std::vector<CellStatistics> cells;  // in the study's order
};

// A class of waypoints of all walks: by distance walked, time since the recording began ("epoch"),
// time since the last scan, floor, phone or the walk's distance to the survey.
struct BreakdownRow {
  std::string by;     // "distance walked, m"
  std::string value;  // "10 to 25"
  int walks = 0;      // with such a waypoint
  std::vector<ErrorSummary> cells;
};

// What a factor takes off the mean error of section `all`: its Shapley value over the subsets.
struct FactorContribution {
  std::string factor;
  double removes_m = 0;
  Interval interval_m;  // 95 %, bootstrap over walks
};

struct DatasetStatistics {
  std::string name;
  std::vector<StudySection> sections;
  std::vector<BreakdownRow> breakdown;
  std::vector<FactorContribution> contributions;   // empty unless every subset was run
  std::vector<std::map<std::string, int>> status;  // walks by status, per cell
};

// Every statistic of a study, data set by data set.
std::vector<DatasetStatistics> ComputeStatistics(const StudyResults& results);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_STUDY_STUDY_STATISTICS_H_
