#include "solvers/baselines/mufaf/map_update.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace walkgraph {
namespace {

std::vector<Eigen::Index> NearestCells(const CellMap& map, const Eigen::Vector2d& position_m,
                                       int count) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(map.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const auto squared = [&](Eigen::Index cell) {
    return (map.centers_m()[static_cast<std::size_t>(cell)] - position_m).squaredNorm();
  };
  const auto k = std::clamp<std::ptrdiff_t>(count, 1, map.size());
  std::partial_sort(order.begin(), order.begin() + k, order.end(),
                    [&](Eigen::Index a, Eigen::Index b) {
                      return squared(a) != squared(b) ? squared(a) < squared(b) : a < b;
                    });
  order.resize(static_cast<std::size_t>(k));
  return order;
}

}  // namespace

AdaptiveCellMap::AdaptiveCellMap(CellMap map, const MapUpdateSettings& settings)
    : map_(std::move(map)), settings_(settings) {
  FitVariograms();
}

void AdaptiveCellMap::FitVariograms() {
  variograms_.clear();
  for (Eigen::Index a = 0; a < map_.anchors(); ++a) {
    variograms_.push_back(FitSpherical(
        MeasureVariogram(map_.centers_m(), map_.mean_dbm().row(a).transpose(), settings_.lags)));
  }
  since_fit_ = 0;
}

Eigen::VectorXd AdaptiveCellMap::SignalsAt(const Eigen::Vector2d& position_m) const {
  const std::vector<Eigen::Index> cells = NearestCells(map_, position_m, settings_.neighbours);
  std::vector<Eigen::Vector2d> centers;
  for (const Eigen::Index cell : cells) {
    centers.push_back(map_.centers_m()[static_cast<std::size_t>(cell)]);
  }
  Eigen::VectorXd signals(map_.anchors());
  for (Eigen::Index a = 0; a < map_.anchors(); ++a) {
    Eigen::VectorXd values(static_cast<Eigen::Index>(cells.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      values(static_cast<Eigen::Index>(i)) = map_.mean_dbm()(a, cells[i]);
    }
    const SphericalVariogram& variogram = variograms_[static_cast<std::size_t>(a)];
    signals(a) = settings_.interpolation == MapInterpolation::kKriging
                     ? OrdinaryKriging(variogram, centers, values, position_m).value
                     : CovarianceInterpolation(variogram, map_.mean_dbm().row(a).mean(), centers,
                                               values, position_m)
                           .value;
  }
  return signals;
}

bool AdaptiveCellMap::Offer(const Eigen::Vector2d& position_m, const Eigen::VectorXd& rssi_dbm) {
  const Eigen::VectorXd known = SignalsAt(position_m);
  if (!((known - rssi_dbm).norm() < settings_.threshold_db)) return false;
  map_.AddSample(map_.NearestCell(position_m),
                 settings_.store == StoreRule::kObserved ? rssi_dbm : known, settings_.memory);
  if (++since_fit_ >= settings_.refit_every) FitVariograms();
  return true;
}

}  // namespace walkgraph
