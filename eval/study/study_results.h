#ifndef WALKGRAPH_EVAL_STUDY_STUDY_RESULTS_H_
#define WALKGRAPH_EVAL_STUDY_STUDY_RESULTS_H_

#include <cstddef>
#include <string>
#include <vector>

#include "eval/study/study_folder.h"

namespace walkgraph {

// A data set's walks with the results of every cell, in the order of the study's cells.
struct DatasetResults {
  std::string name;
  std::vector<WalkCells> walks;  // by id
};

struct StudyResults {
  StudyRecord record;
  std::vector<DatasetResults> datasets;
  std::size_t missing = 0;  // walks that lack a cell; they are not among the results
};

// Reads the results that `record` asks for from folders of the same study, each walk from the first
// that has it. Precondition: no folder differs in its inputs.
StudyResults ReadStudyResults(const std::vector<std::string>& dirs, const StudyRecord& record);

// The errors that a cell is scored by: its own, or those of the map's centroid.
const std::vector<WaypointError>& ScoredErrors(const WalkCells& walk, std::size_t cell);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_STUDY_STUDY_RESULTS_H_
