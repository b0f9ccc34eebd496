#ifndef WALKGRAPH_SOLVERS_FLOOR_SOLUTION_H_
#define WALKGRAPH_SOLVERS_FLOOR_SOLUTION_H_

#include <vector>

#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"
#include "graph/walk_graph.h"
#include "solvers/modes.h"
#include "solvers/settings.h"

namespace walkgraph {

// A walk explained on one floor.
struct FloorSolution {
  WalkGraph walk;
  std::vector<Mode> modes;  // best first
  int failed_solves = 0;
  double unknown_nats = 0;  // see UnknownReadingsCost

  double negative_log_mass() const { return modes.front().negative_log_mass + unknown_nats; }
};

// Explains the evidence on every candidate floor, the best floor first (see CandidateFloors). The
// evidence must be in canonical order.
std::vector<FloorSolution> SolveFloors(const Site& site, const Evidence& evidence,
                                       const FactorSettings& factors,
                                       const SolverSettings& settings);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_FLOOR_SOLUTION_H_
