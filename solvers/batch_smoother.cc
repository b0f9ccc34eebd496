#include "solvers/batch_smoother.h"

#include <string>
#include <utility>
#include <vector>

#include "graph/graph_part.h"
#include "graph/walk_graph.h"
#include "solvers/baselines/floor_tracker.h"
#include "solvers/describe.h"
#include "solvers/evidence_order.h"
#include "solvers/floor_states.h"
#include "solvers/initial_trajectory.h"
#include "solvers/modes.h"

namespace walkgraph {
namespace {

// Where the errors of maps have yet to be conditioned on the places of a mode, its first solve only
// says which mode that is: it may end at ten times the tolerance.
SolverSettings FirstSolve(const SolverSettings& settings, const WalkGraph& walk) {
  SolverSettings first = settings;
  if (!walk.map_errors.empty()) first.function_tolerance *= 10;
  return first;
}

// Drops modes that no refinement brings back. It moves them against each other by some nats, a
// dozen at most among those within thirty of the best (38 walks of a museum, 2026-11-27).
void DropHopeless(double mode_limit_nats, std::vector<Mode>* modes) {
  const double limit = modes->front().negative_log_mass + 4 * mode_limit_nats;
  std::erase_if(*modes, [limit](const Mode& mode) { return mode.negative_log_mass > limit; });
}

}  // namespace

EstimateResult BatchSmoother::Estimate(const Site& site, const Evidence& unsorted) const {
  const Evidence evidence = InCanonicalOrder(unsorted);
  const FloorTrack track = TrackFloors(site, evidence, factors_);
  WalkGraph walk = BuildWalkGraph(site, evidence, factors_, track.path);
  const GraphPart whole = WholeGraph(walk.graph);
  std::vector<Mode> modes;
  int failed_solves = 0;
  for (const InitialTrajectory& start :
       ProposeTrajectories(site, evidence, factors_, solver_, track.path)) {
    modes.push_back(SolveFrom(start, whole, FirstSolve(solver_, walk), &walk, &failed_solves));
  }
  RankModes(solver_, whole, &walk, &modes);
  if (!walk.map_errors.empty()) {
    DropHopeless(solver_.mode_limit_nats, &modes);
    for (Mode& mode : modes) {
      mode = RefineOnPlaces(std::move(mode), whole, solver_, &walk, &failed_solves);
    }
    RankModes(solver_, whole, &walk, &modes);
  }
  EstimateResult result = Describe(walk, modes, solver_.mode_limit_nats);
  AppendFloorStates(track, &result.slow_states);
  if (failed_solves > 0) {
    result.messages.push_back(std::to_string(failed_solves) +
                              " solves failed and kept their starts");
  }
  return result;
}

}  // namespace walkgraph
