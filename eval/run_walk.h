#ifndef WALKGRAPH_EVAL_RUN_WALK_H_
#define WALKGRAPH_EVAL_RUN_WALK_H_

#include <memory>
#include <string>
#include <vector>

#include "eval/loaded_walk.h"
#include "eval/outcome.h"
#include "frontends/radio_map/site.h"
#include "solvers/estimator.h"

namespace walkgraph {

// What a run does with each walk.
struct WalkRunOptions {
  std::string out;  // folder of the result files
  std::vector<std::string> methods;
  bool tum = false;
  double waypoint_sigma_m = 0;
};

// Runs every estimator (in the order of options.methods) on a walk, writes the walk's result files
// and returns the scores. A walk that could not be read gets a row per method too.
WalkOutcome RunWalk(const WalkRunOptions& options, const Site& site,
                    const std::vector<std::unique_ptr<Estimator>>& estimators,
                    const LoadedWalk& walk, int fold);

// By waypoint, the errors of an answer in the middle of the surveyed part of the floor: what a
// missing output is scored as.
std::vector<WaypointError> CentroidErrors(const Site& site, const LoadedWalk& walk);

// One method on one walk, whose readings are aligned to the site. An exception or a pose that is
// not finite becomes status `diverged` without a trajectory. `truth` (building frame) is shown to
// methods alone that ask for it.
EstimateResult RunMethod(const Estimator& estimator, const Site& site, const Evidence& evidence,
                         const Truth& truth);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_RUN_WALK_H_
