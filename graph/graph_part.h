#ifndef WALKGRAPH_GRAPH_GRAPH_PART_H_
#define WALKGRAPH_GRAPH_GRAPH_PART_H_

#include <vector>

#include "graph/factor_graph.h"
#include "graph/linear_prior.h"
#include "graph/linearize.h"

namespace walkgraph {

// The blocks and factors of a graph that take part in a problem, and what those left behind that
// once did.
struct GraphPart {
  std::vector<int> blocks;   // constant ones may be among them
  std::vector<int> factors;  // only on these blocks and constant ones
  std::vector<LinearPrior> priors;
};

// Everything.
GraphPart WholeGraph(const FactorGraph& graph);

// The part linearised at the graph's values, priors last.
LinearSystem Linearize(const FactorGraph& graph, const GraphPart& part, const VariableIndex& index);

// -log density of the part's factors and half the squares of its priors, nats.
double NegativeLogDensity(const FactorGraph& graph, const GraphPart& part);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_GRAPH_PART_H_
