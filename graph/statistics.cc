#include "graph/statistics.h"

#include <cmath>
#include <map>
#include <memory>

#include "factors/loss.h"

namespace walkgraph {
namespace {

bool IsDownweighted(const ceres::LossFunction* loss, double squared_norm) {
  if (loss == nullptr) return false;
  double rho[3];
  loss->Evaluate(squared_norm, rho);
  return rho[1] < 0.5;
}

FactorFit FitOf(const FactorGraph& graph, const GraphFactor& factor) {
  std::vector<const double*> blocks;
  for (const int block : factor.blocks) blocks.push_back(graph.value(block));
  Eigen::VectorXd residual(factor.cost->num_residuals());
  factor.cost->Evaluate(blocks.data(), residual.data(), nullptr);
  const std::unique_ptr<ceres::LossFunction> row_loss = MakeLoss(factor.row_loss, 1);
  const ceres::LossFunction* loss = row_loss ? row_loss.get() : factor.loss.get();
  FactorFit fit{factor.type, factor.arrival_ns, 0, factor.dimension, 0, 0};
  for (int first = 0; first < factor.whitened_rows; first += factor.dimension) {
    double squared = 0;
    for (int row = first; row < first + factor.dimension; ++row) {
      const double value = UndoLoss(factor.row_loss, residual[row] / std::sqrt(factor.weight));
      squared += value * value;
    }
    ++fit.count;
    fit.mean_squared_whitened += squared / factor.dimension;
    fit.downweighted += IsDownweighted(loss, squared) ? 1 : 0;
  }
  fit.mean_squared_whitened /= fit.count;
  return fit;
}

}  // namespace

std::vector<FactorFit> ComputeFits(const FactorGraph& graph) {
  std::vector<FactorFit> fits;
  for (const GraphFactor& factor : graph.factors()) {
    if (factor.whitened_rows > 0) fits.push_back(FitOf(graph, factor));
  }
  return fits;
}

std::vector<ResidualStatistics> PoolByType(const std::vector<FactorFit>& fits) {
  std::map<std::string, ResidualStatistics> by_type;
  for (const FactorFit& fit : fits) {
    ResidualStatistics& sum = by_type[fit.type];
    sum.dimension = fit.dimension;
    sum.count += fit.count;
    sum.mean_squared_whitened += fit.mean_squared_whitened * fit.count;
    sum.downweighted += fit.downweighted;
  }
  std::vector<ResidualStatistics> all;
  for (auto& [type, statistics] : by_type) {
    statistics.type = type;
    statistics.mean_squared_whitened /= static_cast<double>(statistics.count);
    all.push_back(statistics);
  }
  return all;
}

std::vector<ResidualStatistics> ComputeStatistics(const FactorGraph& graph) {
  return PoolByType(ComputeFits(graph));
}

}  // namespace walkgraph
