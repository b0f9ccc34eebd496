#ifndef WALKGRAPH_EVAL_REPORT_COURSES_H_
#define WALKGRAPH_EVAL_REPORT_COURSES_H_

#include <nlohmann/json.hpp>
#include <string>

namespace walkgraph {

// Adds to a walk of ReadResultFolder what the page draws over its time: for each method "states"
// ({name: [[seconds, value, sigma]]} of states/) and "residuals" ({factor: [[seconds, residual in
// sigmas]]} of explain/), and for the walk "barometer" ([[seconds, height in m]]). What there is no
// file for is left out.
void AddCourses(const std::string& dir, nlohmann::ordered_json* walk);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_REPORT_COURSES_H_
