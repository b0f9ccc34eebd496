#ifndef WALKGRAPH_GRAPH_POSTERIOR_H_
#define WALKGRAPH_GRAPH_POSTERIOR_H_

#include "graph/factor_graph.h"

namespace walkgraph {

// -log density of one factor at the graph's values, normaliser included, nats.
double NegativeLogDensity(const FactorGraph& graph, int factor);

// Of all factors: -log of the posterior density up to the evidence of the whole data.
double NegativeLogDensity(const FactorGraph& graph);

// -log of the probability mass of a mode, by Laplace's approximation: with H = J^T J of n variables
// at the mode, -log density + 1/2 log det H - n/2 log 2 pi. This is what tells a narrow good fit
// from a broad one; a solver's cost does not.
double NegativeLogModeMass(double negative_log_density, double log_det_hessian, int variables);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_POSTERIOR_H_
