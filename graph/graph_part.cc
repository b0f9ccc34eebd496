#include "graph/graph_part.h"

#include <numeric>
#include <optional>

#include "graph/posterior.h"

namespace walkgraph {
namespace {

LinearFactor PriorAtValues(const LinearPrior& prior, const FactorGraph& graph,
                           const VariableIndex& index) {
  std::vector<int> variables;
  for (const int block : prior.blocks) variables.push_back(index.variable(block));
  return AtValues(prior, graph, graph.values(), variables);
}

}  // namespace

GraphPart WholeGraph(const FactorGraph& graph) {
  GraphPart part;
  part.blocks.resize(graph.blocks().size());
  part.factors.resize(graph.factors().size());
  std::iota(part.blocks.begin(), part.blocks.end(), 0);
  std::iota(part.factors.begin(), part.factors.end(), 0);
  return part;
}

LinearSystem Linearize(const FactorGraph& graph, const GraphPart& part,
                       const VariableIndex& index) {
  LinearSystem system = Linearize(graph, part.factors, {graph.values(), std::nullopt}, index);
  for (const LinearPrior& prior : part.priors) {
    system.factors.push_back(PriorAtValues(prior, graph, index));
  }
  return system;
}

double NegativeLogDensity(const FactorGraph& graph, const GraphPart& part) {
  double sum = 0;
  for (const int factor : part.factors) sum += NegativeLogDensity(graph, factor);
  for (const LinearPrior& prior : part.priors) {
    sum += 0.5 * AtValues(prior, graph, graph.values(), {}).residual.squaredNorm();
  }
  return sum;
}

}  // namespace walkgraph
