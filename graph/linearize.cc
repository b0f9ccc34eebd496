#include "graph/linearize.h"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace walkgraph {
namespace {

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::vector<int> AllOf(std::size_t count) {
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::vector<const double*> BlockPointers(const FactorGraph& graph, const GraphFactor& factor,
                                         const Eigen::VectorXd& values) {
  std::vector<const double*> pointers;
  pointers.reserve(factor.blocks.size());
  for (const int block : factor.blocks) {
    pointers.push_back(values.data() + graph.block(block).offset);
  }
  return pointers;
}

double LossScale(const GraphFactor& factor, const Eigen::VectorXd& residual) {
  if (!factor.loss) return 1.0;
  double rho[3];
  factor.loss->Evaluate(residual.squaredNorm(), rho);
  return std::sqrt(rho[1]);
}

}  // namespace

VariableIndex::VariableIndex(const FactorGraph& graph, const std::vector<int>& blocks)
    : variables_(graph.blocks().size(), -1) {
  for (const int block : blocks) {
    if (graph.block(block).constant) continue;
    variables_[static_cast<std::size_t>(block)] = static_cast<int>(blocks_.size());
    blocks_.push_back(block);
  }
}

VariableIndex::VariableIndex(const FactorGraph& graph)
    : VariableIndex(graph, AllOf(graph.blocks().size())) {}

LinearFactor LinearizeFactor(const FactorGraph& graph, int factor_index,
                             const LinearizationPoint& point, const VariableIndex& index) {
  const GraphFactor& factor = graph.factor(factor_index);
  const int rows = factor.cost->num_residuals();
  LinearFactor linear;
  linear.residual.resize(rows);
  std::vector<RowMajorMatrix> jacobians;
  jacobians.reserve(factor.blocks.size());
  std::vector<double*> targets;
  int columns = 0;
  for (const int block : factor.blocks) {
    const int size = graph.block(block).size();
    const bool constant = index.variable(block) < 0;
    jacobians.emplace_back(rows, size);
    targets.push_back(constant ? nullptr : jacobians.back().data());
    if (constant) continue;
    linear.blocks.push_back(index.variable(block));
    columns += size;
  }
  const Eigen::VectorXd& jacobian_at = point.jacobian_at ? *point.jacobian_at : point.residual_at;
  factor.cost->Evaluate(BlockPointers(graph, factor, jacobian_at).data(), linear.residual.data(),
                        targets.data());
  if (point.jacobian_at) {  // the residual that stays is the one at its own point
    factor.cost->Evaluate(BlockPointers(graph, factor, point.residual_at).data(),
                          linear.residual.data(), nullptr);
  }
  const double scale = LossScale(factor, linear.residual);
  linear.residual *= scale;
  linear.jacobian.resize(rows, columns);
  int column = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (targets[i] == nullptr) continue;
    linear.jacobian.middleCols(column, jacobians[i].cols()) = scale * jacobians[i];
    column += static_cast<int>(jacobians[i].cols());
  }
  return linear;
}

LinearSystem Linearize(const FactorGraph& graph, const std::vector<int>& factors,
                       const LinearizationPoint& point, const VariableIndex& index) {
  LinearSystem system;
  for (int i = 0; i < index.size(); ++i) {
    system.block_sizes.push_back(graph.block(index.block(i)).size());
  }
  system.factors.reserve(factors.size());
  for (const int factor : factors) {
    if (graph.factor(factor).one_sided) continue;
    LinearFactor linear = LinearizeFactor(graph, factor, point, index);
    if (!linear.blocks.empty()) system.factors.push_back(std::move(linear));
  }
  return system;
}

LinearSystem Linearize(const FactorGraph& graph, const VariableIndex& index) {
  return Linearize(graph, AllOf(graph.factors().size()), {graph.values(), std::nullopt}, index);
}

}  // namespace walkgraph
