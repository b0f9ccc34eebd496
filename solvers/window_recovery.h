#ifndef WALKGRAPH_SOLVERS_WINDOW_RECOVERY_H_
#define WALKGRAPH_SOLVERS_WINDOW_RECOVERY_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "data/trajectory.h"
#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"
#include "graph/linear_prior.h"
#include "graph/walk_graph.h"
#include "solvers/modes.h"
#include "solvers/settings.h"

namespace walkgraph {

// What the whole-walk smoother makes of a stretch of a walk.
struct Recovery {
  WalkGraph walk;  // of that stretch alone
  Mode mode;
};

// Holds the track that a window followed against the whole-walk smoother on the recent evidence:
// the smoother sees the whole floor, the window the neighbourhood of its own modes. Both are solved
// on the same graph, the track as one more start; the track is lost where the best mode is another
// and better by `margin_nats` of posterior mass. None: the track stands, or there is nothing to
// compare. `track` holds positions and headings over the recent evidence.
std::optional<Recovery> FindLostTrack(const Site& site, const Evidence& recent,
                                      const FactorSettings& factors, const SolverSettings& solver,
                                      const Trajectory& track, double margin_nats,
                                      const FloorPath& floors);

// Moves blocks of a window to a recovery: nodes to its trajectory, slow states to its own that hold
// at their time. `blocks` are the window's, `values` those of its graph.
void MoveTo(const Recovery& recovery, const FactorGraph& graph, const std::vector<int>& blocks,
            Eigen::VectorXd* values);

// What stands for all that the window has forgotten: the first node, the first knot of every
// slow state and all from before the first node, each alone, with twice the recovery's sigma,
// because the window's own evidence took part in that. Precondition: MoveTo(recovery, graph,
// blocks, values).
LinearPrior PriorFrom(const Recovery& recovery, const FactorGraph& graph,
                      const std::vector<int>& blocks, const Eigen::VectorXd& values);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_WINDOW_RECOVERY_H_
