#include "graph/linear_prior.h"

namespace walkgraph {

LinearFactor AtValues(const LinearPrior& prior, const FactorGraph& graph,
                      const Eigen::VectorXd& values, const std::vector<int>& variables) {
  Eigen::VectorXd step(prior.point.size());
  Eigen::Index row = 0;
  for (const int block : prior.blocks) {
    const Eigen::Index size = graph.block(block).size();
    step.segment(row, size) =
        values.segment(graph.block(block).offset, size) - prior.point.segment(row, size);
    row += size;
  }
  return {variables, prior.jacobian, prior.residual + prior.jacobian * step};
}

LinearPriorCost::LinearPriorCost(const LinearPrior& prior, const FactorGraph& graph)
    : prior_(prior) {
  set_num_residuals(static_cast<int>(prior.residual.size()));
  for (const int block : prior.blocks) {
    mutable_parameter_block_sizes()->push_back(graph.block(block).size());
  }
}

bool LinearPriorCost::Evaluate(const double* const* blocks, double* residual,
                               double** jacobians) const {
  using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::Map<Eigen::VectorXd> r(residual, num_residuals());
  r = prior_.residual;
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < parameter_block_sizes().size(); ++i) {
    const Eigen::Index size = parameter_block_sizes()[i];
    const auto jacobian = prior_.jacobian.middleCols(column, size);
    r += jacobian *
         (Eigen::Map<const Eigen::VectorXd>(blocks[i], size) - prior_.point.segment(column, size));
    if (jacobians != nullptr && jacobians[i] != nullptr) {
      if (size == 1) {  // a row-major matrix of one column is one that Eigen refuses to map
        Eigen::Map<Eigen::VectorXd>(jacobians[i], num_residuals()) = jacobian.col(0);
      } else {
        Eigen::Map<RowMajorMatrix>(jacobians[i], num_residuals(), size) = jacobian;
      }
    }
    column += size;
  }
  return true;
}

}  // namespace walkgraph
