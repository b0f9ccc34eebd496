#ifndef WALKGRAPH_SOLVERS_GRAPH_SOLVER_H_
#define WALKGRAPH_SOLVERS_GRAPH_SOLVER_H_

#include <vector>

#include "graph/factor_graph.h"
#include "graph/linear_prior.h"
#include "solvers/settings.h"

namespace walkgraph {

struct SolveResult {
  bool ok = false;  // false: the values are what they were before
  int iterations = 0;
};

// Moves a graph's values to a local minimum of the given factors plus a marginal prior (nullptr:
// none) by Levenberg-Marquardt (Ceres, one thread, no BLAS: equal input gives equal bytes). A solve
// that fails or ends in something not finite leaves the values as they were.
SolveResult SolveGraph(const std::vector<int>& factors, const LinearPrior* prior,
                       const SolverSettings& settings, FactorGraph* graph);

// The same for all factors of the graph.
SolveResult SolveGraph(const SolverSettings& settings, FactorGraph* graph);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_GRAPH_SOLVER_H_
