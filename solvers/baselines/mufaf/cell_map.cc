#include "solvers/baselines/mufaf/cell_map.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace walkgraph {
namespace {

// Distance of the signals to each cell's mean: dB, or for Mahalanobis in standard deviations.
Eigen::VectorXd SignalDistances(const CellMap& map, const Eigen::VectorXd& rssi_dbm,
                                CellEstimator estimator) {
  const Eigen::ArrayXXd squared = (map.mean_dbm().colwise() - rssi_dbm).array().square();
  if (estimator != CellEstimator::kMahalanobis) return squared.colwise().sum().sqrt();
  return (squared / map.variance_db2().array()).colwise().sum().sqrt();
}

Eigen::Vector2d MeanOfNearest(const CellMap& map, const Eigen::VectorXd& distance, int count) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(map.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const auto k = std::clamp<std::ptrdiff_t>(count, 1, map.size());
  std::partial_sort(order.begin(), order.begin() + k, order.end(),
                    [&](Eigen::Index a, Eigen::Index b) {
                      return distance(a) != distance(b) ? distance(a) < distance(b) : a < b;
                    });
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double used = 0;
  for (std::ptrdiff_t i = 0; i < k; ++i) {
    const Eigen::Index cell = order[static_cast<std::size_t>(i)];
    if (!std::isfinite(distance(cell))) break;  // left out
    sum += map.centers_m()[static_cast<std::size_t>(cell)];
    ++used;
  }
  return sum / used;
}

}  // namespace

void CellMap::AddCell(const Eigen::Vector2d& center_m, const Eigen::VectorXd& mean_dbm,
                      const Eigen::VectorXd& variance_db2, double count) {
  if (size() == mean_dbm_.cols()) {
    const Eigen::Index room = std::max<Eigen::Index>(16, 2 * size());
    mean_dbm_.conservativeResize(anchors_, room);
    variance_db2_.conservativeResize(anchors_, room);
  }
  centers_m_.push_back(center_m);
  mean_dbm_.col(size() - 1) = mean_dbm;
  variance_db2_.col(size() - 1) = variance_db2;
  count_.push_back(count);
}

void CellMap::AddSample(Eigen::Index cell, const Eigen::VectorXd& rssi_dbm, int memory) {
  double& count = count_[static_cast<std::size_t>(cell)];
  count = memory > 0 ? std::min(count + 1, static_cast<double>(memory)) : count + 1;
  mean_dbm_.col(cell) += (rssi_dbm - mean_dbm_.col(cell)) / count;
}

Eigen::Index CellMap::NearestCell(const Eigen::Vector2d& position_m) const {
  const auto nearest =
      std::min_element(centers_m_.begin(), centers_m_.end(), [&](const auto& a, const auto& b) {
        return (a - position_m).squaredNorm() < (b - position_m).squaredNorm();
      });
  return nearest - centers_m_.begin();
}

Eigen::Vector2d EstimatePosition(const CellMap& map, const Eigen::VectorXd& rssi_dbm,
                                 const CellEstimatorSettings& settings, Eigen::Index left_out) {
  Eigen::VectorXd distance = SignalDistances(map, rssi_dbm, settings.estimator);
  if (left_out >= 0) distance(left_out) = std::numeric_limits<double>::infinity();
  const CellEstimator estimator = settings.estimator;
  if (estimator == CellEstimator::kNearestNeighbours) {
    return MeanOfNearest(map, distance, settings.neighbours);
  }
  if (estimator == CellEstimator::kEuclidean || estimator == CellEstimator::kMahalanobis) {
    return MeanOfNearest(map, distance, 1);
  }
  // Relative to the nearest: far from every cell all kernels would underflow.
  const bool gaussian = estimator == CellEstimator::kGaussian;
  const auto exponent = [&](double d) {
    const double x = d / settings.bandwidth_db;
    return gaussian ? 0.5 * x * x : x;
  };
  const double least = exponent(distance.minCoeff());
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weights = 0;
  for (Eigen::Index c = 0; c < map.size(); ++c) {
    if (!std::isfinite(distance(c))) continue;
    const double weight = std::exp(least - exponent(distance(c)));
    sum += weight * map.centers_m()[static_cast<std::size_t>(c)];
    weights += weight;
  }
  return sum / weights;
}

double LeaveOneCellOutError(const CellMap& map, const CellEstimatorSettings& settings,
                            Eigen::Index most) {
  const Eigen::Index count = std::min(most, map.size());
  double sum = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index cell = i * map.size() / count;
    const Eigen::Vector2d estimate =
        EstimatePosition(map, map.mean_dbm().col(cell), settings, cell);
    sum += (estimate - map.centers_m()[static_cast<std::size_t>(cell)]).norm();
  }
  return sum / static_cast<double>(count);
}

}  // namespace walkgraph
