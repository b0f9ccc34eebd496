#ifndef WALKGRAPH_SOLVERS_INITIAL_TRAJECTORY_H_
#define WALKGRAPH_SOLVERS_INITIAL_TRAJECTORY_H_

#include <string>
#include <vector>

#include "data/trajectory.h"
#include "factors/floor_path.h"
#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// Where a walk may have been: what a smoother starts from.
struct InitialTrajectory {
  std::string source;     // "viterbi", "dead_reckoning 2"
  Trajectory trajectory;  // positions and headings; no covariance
};

// Starts worth refining, the most promising of each source first, never empty: the distinct paths
// of the discrete smoother, then at most `placements` rigid ones of the dead-reckoned walk
// (PlaceDeadReckoning). Only factors that are switched on take part. Where the evidence holds no
// position, the one start is dead reckoning about the middle of the floor.
std::vector<InitialTrajectory> ProposeTrajectories(const Site& site, const Evidence& evidence,
                                                   const FactorSettings& factors,
                                                   const FloorPath& floors, int placements);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_INITIAL_TRAJECTORY_H_
