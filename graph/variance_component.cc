#include "graph/variance_component.h"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/SpecialFunctions>

namespace walkgraph {
namespace {

bool IsOfGroup(const LinearFactor& factor, const std::vector<bool>& in_group) {
  return std::all_of(factor.blocks.begin(), factor.blocks.end(),
                     [&in_group](int block) { return in_group[static_cast<std::size_t>(block)]; });
}

// Joint covariance of a factor's blocks, in their order.
Eigen::MatrixXd CovarianceOf(const LinearFactor& factor, const MarginalCovariance& marginals) {
  Eigen::MatrixXd joint(factor.jacobian.cols(), factor.jacobian.cols());
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < factor.blocks.size(); ++i) {
    const Eigen::MatrixXd& own = marginals.block(factor.blocks[i]).covariance;
    const Eigen::Index rows = own.rows();
    joint.block(row, row, rows, rows) = own;
    Eigen::Index column = row + rows;
    for (std::size_t j = i + 1; j < factor.blocks.size(); ++j) {
      const Eigen::MatrixXd pair = marginals.Joint(factor.blocks[i], factor.blocks[j])->covariance;
      const Eigen::Index columns = pair.cols() - rows;
      joint.block(row, column, rows, columns) = pair.topRightCorner(rows, columns);
      joint.block(column, row, columns, rows) = pair.bottomLeftCorner(columns, rows);
      column += columns;
    }
    row += rows;
  }
  return joint;
}

}  // namespace

double VarianceComponent::Inflation(double level) const {
  if (!(redundancy >= 1.0)) return 1.0;
  const double exceeded_by_chance = Eigen::numext::igammac(0.5 * redundancy, 0.5 * squares);
  return squares > redundancy && exceeded_by_chance < level ? squares / redundancy : 1.0;
}

VarianceComponent EstimateVarianceComponent(const LinearSystem& system,
                                            const std::vector<bool>& in_group,
                                            const MarginalCovariance& marginals) {
  VarianceComponent component;
  for (const LinearFactor& factor : system.factors) {
    if (!IsOfGroup(factor, in_group)) continue;
    const Eigen::MatrixXd& jacobian = factor.jacobian;
    const double used = (jacobian * CovarianceOf(factor, marginals)).cwiseProduct(jacobian).sum();
    component.squares += factor.residual.squaredNorm();
    component.redundancy += static_cast<double>(factor.residual.size()) - used;
  }
  return component;
}

void WidenBlocks(const std::vector<double>& ratio, const std::vector<bool>& in_group,
                 LinearSystem* system) {
  for (LinearFactor& linear : system->factors) {
    if (!IsOfGroup(linear, in_group)) continue;
    Eigen::Index column = 0;
    for (const int block : linear.blocks) {
      const auto b = static_cast<std::size_t>(block);
      const Eigen::Index columns = system->block_sizes[b];
      linear.jacobian.middleCols(column, columns) /= ratio[b];
      column += columns;
    }
  }
}

void InflateVariance(double factor, const std::vector<bool>& in_group, LinearSystem* system) {
  const double scale = 1.0 / std::sqrt(factor);
  for (LinearFactor& linear : system->factors) {
    if (!IsOfGroup(linear, in_group)) continue;
    linear.jacobian *= scale;
    linear.residual *= scale;
  }
}

}  // namespace walkgraph
