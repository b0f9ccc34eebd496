#ifndef WALKGRAPH_GRAPH_MARGINALIZATION_H_
#define WALKGRAPH_GRAPH_MARGINALIZATION_H_

#include <optional>
#include <vector>

#include "graph/linear_system.h"

namespace walkgraph {

// Removes blocks from a linear least-squares problem. Only the factors that touch an eliminated
// block take part. The answer is one factor on their other blocks (the separator, ascending): for
// every d there, 1/2 |residual + jacobian d|^2 equals the minimum over the eliminated blocks of the
// sum of those factors, constant included. A caller drops the eliminated blocks and the factors
// that touched them, and adds this one.
//
// The work is orthogonal transformations on the Jacobians (square-root form), never a Schur
// complement of J^T J: accurate to about 1e-16 times the condition number of J, not its square.
// Directions that the factors say nothing about get no row: whatever rounding left there (relative
// pivot under kRankTolerance) is dropped. An eliminated block that no factor touches disappears
// without a trace; an empty separator gives a factor of no blocks, whose residual is the constant.
//
// Nothing is returned if a Jacobian or residual is not finite. Throws std::invalid_argument on a
// malformed system (see CheckShapes), an eliminated index out of range or one given twice.
//
// `log_determinant`, if wanted, becomes log det of the eliminated blocks' information given the
// separator, without dependent pivots: what the determinant of the whole problem loses with them.
std::optional<LinearFactor> MarginalizeBlocks(const LinearSystem& system,
                                              const std::vector<int>& eliminated,
                                              double* log_determinant = nullptr);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_MARGINALIZATION_H_
