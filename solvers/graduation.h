#ifndef WALKGRAPH_SOLVERS_GRADUATION_H_
#define WALKGRAPH_SOLVERS_GRADUATION_H_

#include "graph/factor_graph.h"
#include "graph/graph_part.h"
#include "solvers/graph_solver.h"
#include "solvers/settings.h"

namespace walkgraph {

// SolveGraph() where factors have truncated losses: solves with the parabola, then with losses that
// are less and less convex, each from the solution before (graduated non-convexity, see
// TruncatedLoss). The first is so near the parabola that the worst residual keeps half of its
// weight or more; the last leaves nothing between parabola and cut, or is TruncatedLoss::kFinalMu.
// The losses end there. Without truncated losses it is SolveGraph().
SolveResult SolveGraduated(const GraphPart& part, const SolverSettings& settings,
                           FactorGraph* graph);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_GRADUATION_H_
