#ifndef WALKGRAPH_SOLVERS_WINDOW_HYPOTHESES_H_
#define WALKGRAPH_SOLVERS_WINDOW_HYPOTHESES_H_

#include <Eigen/Core>
#include <vector>

#include "graph/map_error_states.h"
#include "graph/sliding_window.h"
#include "graph/walk_graph.h"
#include "solvers/modes.h"
#include "solvers/settings.h"

namespace walkgraph {

// One explanation of what a window has seen: the same nodes and factors in every one, but solved in
// another mode, and with what left marginalised there.
struct WindowHypothesis {
  SlidingWindow window;
  Eigen::VectorXd values;             // of the graph
  MapErrorConditionals conditionals;  // of the maps' errors, by where this one went
  // As last weighed:
  PointUncertainty uncertainty;  // of the window's part
  double negative_log_mass = 0;  // of all that was ever in the window
  // Of one that was taken up from elsewhere:
  bool taken_up = false;      // and has not been the best yet
  double forgotten_nats = 0;  // of its mass, by what the window does not hold
};

// Takes the graph to a hypothesis: its values, and the maps' errors conditioned as it has them.
void GoTo(const WindowHypothesis& hypothesis, WalkGraph* walk);

// Ranks hypotheses of a walk by the posterior mass about them, best first, and drops those that are
// more than `limit_nats` worse than the best or have come to a better one's path. Leaves the graph
// at the values of one of them.
void WeighHypotheses(const SolverSettings& solver, double limit_nats, WalkGraph* walk,
                     std::vector<WindowHypothesis>* hypotheses);

// Covariance of a block about the best hypothesis's value, over the mixture of all, weighed.
Eigen::MatrixXd MixtureCovariance(const FactorGraph& graph,
                                  const std::vector<WindowHypothesis>& hypotheses, int block);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_WINDOW_HYPOTHESES_H_
