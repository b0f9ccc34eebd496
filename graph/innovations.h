#ifndef WALKGRAPH_GRAPH_INNOVATIONS_H_
#define WALKGRAPH_GRAPH_INNOVATIONS_H_

#include <string>
#include <vector>

#include "graph/factor_graph.h"
#include "graph/graph_part.h"

namespace walkgraph {

// A reading against what was expected of it before it came.
struct Innovation {
  std::string type;   // of its factor
  int count = 0;      // measurements: the readings of a scan
  int dimension = 0;  // of each
  // Residual at the expected state, whitened by the covariance S = I + J P J^T that the reading's
  // noise and the expectation's covariance P give it together, squared, per row: 1 in the mean
  // where both are right (the normalised innovation squared, NIS, over its dimension; Bar-Shalom,
  // Li and Kirubarajan 2001, section 5.4).
  double normalized_squared = 0;
};

// The innovations of `joining`, factors on blocks of the part that do not yet belong to it, at the
// part's minimum, where the graph's values must be. Each is judged alone, so that readings of one
// moment are each compared with what was expected before all of them. Rows are whitened
// measurements under their robust loss, their weight taken out. Factors without whitened rows are
// left out; all are where the part is not finite.
std::vector<Innovation> ComputeInnovations(const FactorGraph& graph, const GraphPart& expected,
                                           const std::vector<int>& joining);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_INNOVATIONS_H_
