#ifndef WALKGRAPH_EVAL_SUMMARY_JSON_H_
#define WALKGRAPH_EVAL_SUMMARY_JSON_H_

#include <map>
#include <string>
#include <vector>

#include "eval/outcome.h"
#include "eval/settings.h"
#include "eval/summary.h"

namespace walkgraph {

// What a run was made of, for the summary.
struct RunDescription {
  std::string split;
  int folds = 0;
  bool floor_given = true;
  Settings settings;  // defaults with the user's values, before calibration
  // Per fold, the keys that calibration moved away from `settings`, with their values.
  std::vector<std::map<std::string, std::string>> calibrated;
  std::map<std::string, std::string> checksums;  // by walk, FNV-1a of the file
};

// summary.json:
//   {"version", "split", "folds", "floor_given", "walks": {"total", "finished", "with_waypoints"},
//    "sections": {"pooled"|"covered"|"floor X"|"all_walks": {method: {"walks", "n", "mean_m",
//      "mean_interval_m": [low, high], "rmse_m", "median_m", "p75_m", "p90_m", "p95_m", "max_m",
//      "floor_accuracy", "coverage50", "coverage95", "nees",
//      "minus": {other: {"mean_m", "interval_m": [low, high]}}}}},
//    "status": {method: {status: walks}}, "configuration": {key: value}, "calibrated": [by fold],
//    "checksums": {walk: hash}}
// A number that does not exist is null.
std::string FormatSummaryJson(const Evaluation& evaluation,
                              const std::vector<SummarySection>& sections,
                              const RunDescription& run);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_SUMMARY_JSON_H_
