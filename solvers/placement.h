#ifndef WALKGRAPH_SOLVERS_PLACEMENT_H_
#define WALKGRAPH_SOLVERS_PLACEMENT_H_

#include <Eigen/Core>
#include <vector>

#include "factors/dead_reckoning.h"
#include "factors/floor_path.h"
#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// A dead-reckoned walk laid on a floor without bending it: position(t) = start + R(rotation)
// walk(t).
struct Placement {
  Eigen::Vector2d start_m = Eigen::Vector2d::Zero();
  double rotation_rad = 0;
  double cost_nats = 0;  // up to a constant that all placements share

  Eigen::Vector2d At(const DeadReckonedPath& walk, TimeNs time_ns) const;
};

// Correlational matching: lays the walk at every surveyed cell of a coarse lattice and in every
// likely direction, and returns the best distinct placements, best first, at most `count`.
// Directions are -20 to 20 degrees about an absolute heading, or all round where there is none.
// Evidence of a time is looked up on the floor of that time; empty where it holds no position.
std::vector<Placement> PlaceDeadReckoning(const Site& site, const Evidence& evidence,
                                          const DeadReckonedPath& walk,
                                          const FactorSettings& settings, const FloorPath& floors,
                                          int count);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_PLACEMENT_H_
