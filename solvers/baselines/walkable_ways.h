#ifndef WALKGRAPH_SOLVERS_BASELINES_WALKABLE_WAYS_H_
#define WALKGRAPH_SOLVERS_BASELINES_WALKABLE_WAYS_H_

#include <span>
#include <vector>

#include "data/building.h"
#include "solvers/baselines/reference_points.h"

namespace walkgraph {

struct WalkableWay {
  int to = 0;
  double distance_m = 0;     // along the shortest way
  double direction_rad = 0;  // straight
};

// From each reference point the shortest ways to all others within `max_distance_m`, itself
// included, by `to`. A way goes from neighbour to neighbour of the lattice (16 directions: at
// most 2.8 % longer than straight), never through an obstacle.
std::vector<std::vector<WalkableWay>> FindWalkableWays(const ReferencePoints& points,
                                                       std::span<const Polygon> obstacles,
                                                       double max_distance_m);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_WALKABLE_WAYS_H_
