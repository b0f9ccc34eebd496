#ifndef WALKGRAPH_SOLVERS_ANCHORED_SMOOTHER_H_
#define WALKGRAPH_SOLVERS_ANCHORED_SMOOTHER_H_

#include <optional>

#include "data/building.h"
#include "data/trajectory.h"
#include "data/truth.h"
#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "solvers/settings.h"

namespace walkgraph {

// Where the person was between surveyed waypoints, by all that the motion sensors say: the walk's
// factor graph without radio maps (steps, turns, absolute headings and their slow states), held at
// every waypoint by a position anchor and solved as one batch. Unlike positions by walked distance
// (SurveyTrajectory) it need not be straight between waypoints.
class AnchoredSmoother {
 public:
  // `waypoint_sigma_m` is the error of a waypoint per axis. Throws std::invalid_argument on factor
  // settings out of range, when first used.
  AnchoredSmoother(const FactorSettings& factors, const SolverSettings& solver,
                   double waypoint_sigma_m)
      : factors_(factors), solver_(solver), waypoint_sigma_m_(waypoint_sigma_m) {}

  // A pose at every node of the graph between the first and the last waypoint, and at these two,
  // with the posterior covariance; before and after nothing is said. `truth` must be in the
  // building frame; readings and anchors of the evidence are not used. None where the graph has no
  // answer: under two waypoints, waypoints on several floors, no step, or a solve that fails.
  std::optional<Trajectory> Smooth(const Building& building, const Truth& truth,
                                   const Evidence& evidence) const;

 private:
  FactorSettings factors_;
  SolverSettings solver_;
  double waypoint_sigma_m_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_ANCHORED_SMOOTHER_H_
