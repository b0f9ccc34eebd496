#ifndef WALKGRAPH_GRAPH_LINEARIZE_H_
#define WALKGRAPH_GRAPH_LINEARIZE_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "graph/factor_graph.h"
#include "graph/linear_system.h"

namespace walkgraph {

// Which blocks of a graph are the variables of a linear system, and in which order.
class VariableIndex {
 public:
  // The given blocks without the constant ones.
  VariableIndex(const FactorGraph& graph, const std::vector<int>& blocks);
  // All variables of the graph.
  explicit VariableIndex(const FactorGraph& graph);

  int size() const { return static_cast<int>(blocks_.size()); }
  // The graph's block of a variable.
  int block(int variable) const { return blocks_[static_cast<std::size_t>(variable)]; }
  // The variable of a graph's block, -1 if it is none.
  int variable(int block) const { return variables_[static_cast<std::size_t>(block)]; }

 private:
  std::vector<int> blocks_;
  std::vector<int> variables_;
};

// Where a system is linearised: residuals at one point, Jacobians at another. They differ only
// where first-estimate Jacobians are wanted. Each is laid out as FactorGraph::values().
struct LinearizationPoint {
  Eigen::VectorXd residual_at;
  std::optional<Eigen::VectorXd> jacobian_at;  // none: the same point
};

// A factor linearised, its blocks renamed by the index. Residual and Jacobian are scaled by the
// root of the loss's slope, as Ceres' corrector does for losses that are nowhere convex upwards
// (all of factors/loss.h). Factors on constant blocks only have no blocks.
// Precondition: the index knows all blocks of the factor that are not constant.
LinearFactor LinearizeFactor(const FactorGraph& graph, int factor, const LinearizationPoint& point,
                             const VariableIndex& index);

// The given factors linearised, without those on constant blocks only and the one-sided ones.
LinearSystem Linearize(const FactorGraph& graph, const std::vector<int>& factors,
                       const LinearizationPoint& point, const VariableIndex& index);

// The whole graph at its present values.
LinearSystem Linearize(const FactorGraph& graph, const VariableIndex& index);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_LINEARIZE_H_
