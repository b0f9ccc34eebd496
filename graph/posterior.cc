#include "graph/posterior.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace walkgraph {

double NegativeLogDensity(const FactorGraph& graph, int index) {
  const GraphFactor& factor = graph.factor(index);
  std::vector<const double*> blocks;
  for (const int block : factor.blocks) blocks.push_back(graph.value(block));
  Eigen::VectorXd residual(factor.cost->num_residuals());
  factor.cost->Evaluate(blocks.data(), residual.data(), nullptr);
  double rho[3] = {residual.squaredNorm(), 1.0, 0.0};
  if (factor.loss) factor.loss->Evaluate(residual.squaredNorm(), rho);
  return 0.5 * rho[0] + factor.log_normaliser;
}

double NegativeLogDensity(const FactorGraph& graph) {
  double sum = 0;
  for (int i = 0; i < static_cast<int>(graph.factors().size()); ++i) {
    sum += NegativeLogDensity(graph, i);
  }
  return sum;
}

double NegativeLogModeMass(double negative_log_density, double log_det_hessian, int variables) {
  return negative_log_density + 0.5 * log_det_hessian -
         0.5 * variables * std::log(2.0 * std::numbers::pi);
}

}  // namespace walkgraph
