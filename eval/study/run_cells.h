#ifndef WALKGRAPH_EVAL_STUDY_RUN_CELLS_H_
#define WALKGRAPH_EVAL_STUDY_RUN_CELLS_H_

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "eval/fold.h"
#include "eval/loaded_walk.h"
#include "eval/study/study.h"
#include "eval/study/walk_cells.h"

namespace walkgraph {

// A cell with its estimator, as one fold calibrated it.
struct FoldCell {
  std::string name;
  std::string configuration;  // hash
  std::unique_ptr<Estimator> estimator;
  double waypoint_sigma_m = 0;
};

std::vector<FoldCell> MakeFoldCells(const Study& study, const std::vector<std::size_t>& cells,
                                    const Fold& fold);

// A walk's results and the wall time of each cell that was computed here, s.
struct CellsRun {
  WalkCells walk;
  std::vector<std::pair<std::string, double>> seconds;  // by cell
};

// Runs the cells on a walk, in their order; results in `earlier` of the same cell and configuration
// are taken over. Stops between cells once `stopped` says so, and then lacks the rest.
CellsRun RunCells(const std::vector<FoldCell>& cells, const Site& site, const LoadedWalk& walk,
                  int fold, const WalkCells* earlier, const std::function<bool()>& stopped);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_STUDY_RUN_CELLS_H_
