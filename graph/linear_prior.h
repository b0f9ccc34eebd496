#ifndef WALKGRAPH_GRAPH_LINEAR_PRIOR_H_
#define WALKGRAPH_GRAPH_LINEAR_PRIOR_H_

#include <ceres/cost_function.h>

#include <Eigen/Core>
#include <vector>

#include "graph/factor_graph.h"
#include "graph/linear_system.h"

namespace walkgraph {

// What marginalised blocks left behind on those that stay: r = residual + jacobian (x - x0), with
// x0 the point it was linearised at. Blocks: those of `blocks`, stacked in that order. Empty after
// construction by default: no blocks, no rows.
struct LinearPrior {
  std::vector<int> blocks;   // of the graph
  Eigen::MatrixXd jacobian;  // rows x sum of the blocks' sizes
  Eigen::VectorXd residual;  // at x0
  Eigen::VectorXd point;     // x0
  bool empty() const { return residual.size() == 0; }
};

// The prior as a factor of a linear system, at the given values (laid out as
// FactorGraph::values()). `variables` renames its blocks.
LinearFactor AtValues(const LinearPrior& prior, const FactorGraph& graph,
                      const Eigen::VectorXd& values, const std::vector<int>& variables);

// The prior as a cost function.
class LinearPriorCost : public ceres::CostFunction {
 public:
  // Keeps a reference: `prior` must outlive the cost function.
  LinearPriorCost(const LinearPrior& prior, const FactorGraph& graph);
  bool Evaluate(const double* const* blocks, double* residual, double** jacobians) const override;

 private:
  const LinearPrior& prior_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_LINEAR_PRIOR_H_
