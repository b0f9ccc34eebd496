#ifndef WALKGRAPH_SOLVERS_GRAPH_SOLVER_H_
#define WALKGRAPH_SOLVERS_GRAPH_SOLVER_H_

#include "graph/factor_graph.h"
#include "graph/graph_part.h"
#include "solvers/settings.h"

namespace walkgraph {

struct SolveResult {
  bool ok = false;  // false: the values are what they were before
  int iterations = 0;
};

// Moves a graph's values to a local minimum of the part's factors and priors by Levenberg-Marquardt
// (Ceres, one thread, no BLAS: equal input gives equal bytes). A solve that fails or ends in
// something not finite leaves the values as they were.
SolveResult SolveGraph(const GraphPart& part, const SolverSettings& settings, FactorGraph* graph);

// One Gauss-Newton step from a minimum that SolveGraph found. A search that watches the cost cannot
// see errors under the root of the cost's rounding, some 1e-8; the gradient can. Does nothing where
// the step is larger than a correction of that kind (the part was not at a minimum).
void PolishSolution(const GraphPart& part, FactorGraph* graph);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_GRAPH_SOLVER_H_
