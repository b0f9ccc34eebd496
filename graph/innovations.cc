#include "graph/innovations.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "graph/linearize.h"
#include "graph/marginal_covariance.h"

namespace walkgraph {
namespace {

std::vector<std::pair<int, int>> PairsOf(const std::vector<LinearFactor>& factors) {
  std::vector<std::pair<int, int>> pairs;
  for (const LinearFactor& factor : factors) {
    for (std::size_t i = 0; i < factor.blocks.size(); ++i) {
      for (std::size_t j = i + 1; j < factor.blocks.size(); ++j) {
        pairs.emplace_back(factor.blocks[i], factor.blocks[j]);
      }
    }
  }
  return pairs;
}

// Of a factor's variables together, in its order.
Eigen::MatrixXd JointCovariance(const MarginalCovariance& marginals,
                                const std::vector<int>& variables) {
  std::vector<Eigen::Index> first = {0};
  for (const int v : variables) {
    first.push_back(first.back() + marginals.block(v).covariance.rows());
  }
  Eigen::MatrixXd joint(first.back(), first.back());
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const Eigen::MatrixXd& own = marginals.block(variables[i]).covariance;
    joint.block(first[i], first[i], own.rows(), own.cols()) = own;
    for (std::size_t j = i + 1; j < variables.size(); ++j) {
      const Eigen::MatrixXd both = marginals.Joint(variables[i], variables[j])->covariance;
      const Eigen::MatrixXd cross = both.topRightCorner(own.rows(), both.cols() - own.cols());
      joint.block(first[i], first[j], cross.rows(), cross.cols()) = cross;
      joint.block(first[j], first[i], cross.cols(), cross.rows()) = cross.transpose();
    }
  }
  return joint;
}

FactorFit Judge(const GraphFactor& factor, const LinearFactor& linear,
                const MarginalCovariance& marginals) {
  const int rows = factor.whitened_rows;
  const Eigen::MatrixXd jacobian = linear.jacobian.topRows(rows) / std::sqrt(factor.weight);
  const Eigen::VectorXd residual = linear.residual.head(rows) / std::sqrt(factor.weight);
  const Eigen::MatrixXd covariance =
      Eigen::MatrixXd::Identity(rows, rows) +
      jacobian * JointCovariance(marginals, linear.blocks) * jacobian.transpose();
  const double squared = residual.dot(covariance.llt().solve(residual));
  return {factor.type,      factor.arrival_ns, rows / factor.dimension,
          factor.dimension, squared / rows,    0};
}

}  // namespace

std::vector<FactorFit> ComputeInnovations(const FactorGraph& graph, const GraphPart& expected,
                                          const std::vector<int>& joining) {
  const VariableIndex index(graph, expected.blocks);
  std::vector<const GraphFactor*> judged;
  std::vector<LinearFactor> linear;
  for (const int factor : joining) {
    if (graph.factor(factor).whitened_rows == 0) continue;
    judged.push_back(&graph.factor(factor));
    linear.push_back(LinearizeFactor(graph, factor, {graph.values(), std::nullopt}, index));
  }
  if (judged.empty()) return {};
  const auto marginals =
      MarginalCovariance::Compute(Linearize(graph, expected, index), PairsOf(linear));
  if (!marginals) return {};
  std::vector<FactorFit> innovations;
  for (std::size_t i = 0; i < judged.size(); ++i) {
    innovations.push_back(Judge(*judged[i], linear[i], *marginals));
  }
  return innovations;
}

}  // namespace walkgraph
