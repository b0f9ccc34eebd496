#ifndef WALKGRAPH_GRAPH_INNOVATIONS_H_
#define WALKGRAPH_GRAPH_INNOVATIONS_H_

#include <vector>

#include "graph/factor_graph.h"
#include "graph/graph_part.h"
#include "graph/statistics.h"

namespace walkgraph {

// How well readings agree with what was expected of them before they came: the fits of `joining`,
// factors on blocks of the part that do not yet belong to it, at the part's minimum, where the
// graph's values must be. Their rows are whitened by the covariance S = I + J P J^T that a
// reading's noise and the expectation's covariance P give it together, so that the mean square is
// the normalised innovation squared (NIS) over its dimension, 1 in the mean where both are right
// (Bar-Shalom, Li and Kirubarajan 2001, section 5.4).
//
// Each is judged alone, so that readings of one moment are each compared with what was expected
// before all of them. Rows are whitened measurements under their robust loss, their weight taken
// out; none counts as down-weighted. Factors without whitened rows are left out; all are where the
// part is not finite.
std::vector<FactorFit> ComputeInnovations(const FactorGraph& graph, const GraphPart& expected,
                                          const std::vector<int>& joining);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_INNOVATIONS_H_
