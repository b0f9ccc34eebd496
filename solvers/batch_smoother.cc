#include "solvers/batch_smoother.h"

#include <string>
#include <vector>

#include "factors/stair_steps.h"
#include "graph/graph_part.h"
#include "graph/walk_graph.h"
#include "solvers/baselines/floor_tracker.h"
#include "solvers/describe.h"
#include "solvers/evidence_order.h"
#include "solvers/floor_states.h"
#include "solvers/initial_trajectory.h"
#include "solvers/modes.h"

namespace walkgraph {

EstimateResult BatchSmoother::Estimate(const Site& site, const Evidence& unsorted) const {
  Evidence evidence = InCanonicalOrder(unsorted);
  const FloorTrack track = TrackFloors(site, evidence, factors_);
  ShortenStairSteps(track.path, factors_.step, &evidence);
  WalkGraph walk = BuildWalkGraph(site, evidence, factors_, track.path);
  int failed_solves = 0;
  const GraphPart whole = WholeGraph(walk.graph);
  std::vector<Mode> modes =
      FindModes(ProposeTrajectories(site, evidence, factors_, track.path, solver_.hypotheses),
                whole, walk.node_ns.back(), solver_, &walk, &failed_solves);
  const double limit = modes.front().negative_log_mass + solver_.mode_limit_nats;
  for (Mode& mode : modes) {
    if (mode.negative_log_mass > limit) break;  // no part of what is reported
    GoTo(mode, &walk);
    WidenOffSurvey(walk, whole, solver_.map_error_test, &mode.uncertainty);
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
