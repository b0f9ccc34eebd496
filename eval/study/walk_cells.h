#ifndef WALKGRAPH_EVAL_STUDY_WALK_CELLS_H_
#define WALKGRAPH_EVAL_STUDY_WALK_CELLS_H_

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "eval/metrics.h"
#include "solvers/estimator.h"

namespace walkgraph {

// What one cell made of one walk.
struct CellResult {
  std::string cell;
  std::string configuration;  // hash, see ConfigurationHash
  EstimateStatus status = EstimateStatus::kUnsupported;
  std::vector<std::string> messages;
  // By waypoint; empty where the cell has no position to score: no trajectory, or one that nothing
  // ties to the map (status `unobservable`).
  std::vector<WaypointError> errors;
};

// What breakdowns ask of a waypoint.
struct StudyWaypoint {
  double time_s = 0;        // since the recording began
  int floor = 0;            // the true one
  double distance_m = 0;    // walked since the first waypoint, along straight lines
  double since_scan_s = 0;  // since the last reading of any radio; NaN before the first
};

// One walk of a study with the results of its cells: a file of the result folder, and the unit that
// a killed study resumes from.
struct WalkCells {
  std::string walk;
  int fold = 0;
  std::string device;
  double duration_s = 0;
  double survey_distance_m = std::numeric_limits<double>::quiet_NaN();
  std::string error;  // why the walk could not be read, or empty
  std::vector<StudyWaypoint> waypoints;
  std::vector<WaypointError> centroid_errors;  // what a cell without errors is scored as
  std::vector<CellResult> cells;
};

// The result of a cell in one configuration; null where the walk has none.
const CellResult* FindCell(const WalkCells& walk, const std::string& cell,
                           const std::string& configuration);

// JSON, one line per cell, with a checksum of its own. Numbers read back to the same bits.
std::string FormatWalkCells(const WalkCells& walk);

// nullopt where the text is not whole and unchanged.
std::optional<WalkCells> ParseWalkCells(const std::string& text);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_STUDY_WALK_CELLS_H_
