#ifndef WALKGRAPH_EVAL_HONESTY_HONESTY_OUTPUT_H_
#define WALKGRAPH_EVAL_HONESTY_HONESTY_OUTPUT_H_

#include <string>
#include <vector>

#include "eval/honesty/honesty_scores.h"

namespace walkgraph {

// What a run measured. `at_truth` are the factors' whitened residuals at the true states, empty
// where only positions are known.
struct HonestyResult {
  std::vector<std::string> walks;
  std::vector<std::string> methods;
  std::vector<std::vector<WalkHonesty>> outcomes;  // [method][walk]
  StatisticsByType at_truth;
};

// The tables for the terminal: covariances, then mean squared whitened residuals by factor type.
std::string FormatHonesty(const HonestyResult& result);
// The same numbers.
std::string FormatHonestyJson(const HonestyResult& result, const std::string& command_line);
// A row per method, walk and scored node: `method,walk,node,error_m,nees`.
std::string FormatHonestyCsv(const HonestyResult& result);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_HONESTY_HONESTY_OUTPUT_H_
