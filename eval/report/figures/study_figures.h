#ifndef WALKGRAPH_EVAL_REPORT_FIGURES_STUDY_FIGURES_H_
#define WALKGRAPH_EVAL_REPORT_FIGURES_STUDY_FIGURES_H_

#include <map>
#include <string>
#include <vector>

#include "eval/report/figures/figures.h"
#include "eval/study/study_statistics.h"

namespace walkgraph {

// The figures of one data set of a study, on every walk with waypoints. `seconds` is the wall time
// per walk by cell, where it is known. Distributions are drawn of at most twenty cells: where there
// are more, the reference, the cells that lack one factor, then those that are no subsets.
std::vector<Figure> StudyFigures(const StudyRecord& record, const DatasetResults& results,
                                 const DatasetStatistics& statistics,
                                 const std::map<std::string, double>& seconds);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_REPORT_FIGURES_STUDY_FIGURES_H_
