#ifndef WALKGRAPH_EVAL_STUDY_BREAKDOWN_H_
#define WALKGRAPH_EVAL_STUDY_BREAKDOWN_H_

#include <cstddef>
#include <vector>

#include "eval/study/study_statistics.h"

namespace walkgraph {

// The waypoints of all walks by distance walked, time since the recording began, time since the
// last scan, floor, phone and the walk's distance to the survey. Classes without waypoints are left
// out.
std::vector<BreakdownRow> BreakDown(const std::vector<const WalkCells*>& walks, std::size_t cells);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_STUDY_BREAKDOWN_H_
