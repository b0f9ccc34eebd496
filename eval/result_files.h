#ifndef WALKGRAPH_EVAL_RESULT_FILES_H_
#define WALKGRAPH_EVAL_RESULT_FILES_H_

#include <string>
#include <vector>

#include "data/building.h"
#include "data/trajectory.h"
#include "eval/outcome.h"
#include "frontends/evidence/evidence.h"
#include "solvers/estimator.h"

namespace walkgraph {

// The texts of the result files. Numbers have fixed decimals; a NaN is an empty field.

// time_ns,x_m,y_m,z_m,floor,heading_rad,cov_xx,cov_xy,cov_yy,cov_zz,cov_hh,modes: a row per pose.
std::string FormatTrajectoryCsv(const Trajectory& trajectory);

// The TUM format of evo and others: `time_s x y z qx qy qz qw`, rotation about z by the heading.
std::string FormatTrajectoryTum(const Trajectory& trajectory);

// state,time_ns,value,sigma: a row per slow state and knot.
std::string FormatStatesCsv(const std::vector<SlowStateEstimate>& states);

// What an explanation of one estimate needs: {"factors": [{"factor", "count",
// "mean_squared_whitened", "downweighted"}], "residuals": {factor: [[time_ns, mean squared
// whitened, measurements, downweighted]]}, "hypotheses": [{"source", "negative_log_posterior",
// "kept"}], "readings_ns": [times at which transmitters were heard, each once], "barometer":
// [[time_ns, standard-atmosphere height in metres]]}.
std::string FormatExplanation(const EstimateResult& result, const Evidence& evidence);

// A row per walk and method in the order of the evaluation; unfinished walks are left out.
std::string FormatScoresCsv(const Evaluation& evaluation);

// What a plot of one walk needs: {"walk", "fold", "survey_distance_m", "waypoints": [{"time_ns",
// "x_m", "y_m", "floor"}], "methods": {name: {"status", "messages", "errors_m": [by waypoint],
// "nees": [likewise]}}}.
std::string FormatWalkJson(const WalkOutcome& outcome, const std::vector<std::string>& methods);

// What a plot of the building needs: {"name", "floors": [{"number", "name", "height_m",
// "min_corner_m", "max_corner_m", "outline_m", "obstacles_m", "image"?: {"path", "min_corner_m",
// "max_corner_m"}}]}; polygons are lists of rings of [x, y].
std::string FormatBuildingJson(const Building& building);

// Writes trajectories/<walk>.<method>.csv (and .tum), states/<walk>.<method>.csv and, for a graph,
// explain/<walk>.<method>.json under `out`. What is empty gets no file.
void WriteEstimate(const std::string& out, const std::string& walk, const Evidence& evidence,
                   const std::string& method, const EstimateResult& result, bool tum);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_RESULT_FILES_H_
