#ifndef WALKGRAPH_EVAL_REPORT_EXPLAIN_H_
#define WALKGRAPH_EVAL_REPORT_EXPLAIN_H_

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "eval/report/figures/figures.h"

namespace walkgraph {

// Why one walk came out as it did: sentences, and figures over the walk's time.
struct Explanation {
  std::vector<std::string> notes;
  std::vector<Figure> figures;
};

// Reads explain/ of a result folder for `walk`, an element of ReadResultFolder's
// "walks". Notes tell status, fit of each factor, rejected readings, stretches without readings and
// competing hypotheses; figures the errors at the waypoints and the readings that were rejected.
// Throws InputError on files that cannot be used.
Explanation ExplainWalk(const std::string& dir, const nlohmann::ordered_json& walk);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_REPORT_EXPLAIN_H_
