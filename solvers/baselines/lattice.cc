#include "solvers/baselines/lattice.h"

#include <cmath>

namespace walkgraph {
namespace {

// Marks the squares whose centre lies within reach of a point of the survey path.
std::vector<bool> Reachable(const std::vector<Eigen::Vector2d>& path, const Eigen::Vector2d& origin,
                            double spacing_m, int columns, int rows, double reach_m) {
  std::vector<bool> reachable(static_cast<std::size_t>(columns) * rows, false);
  const int reach = static_cast<int>(std::ceil(reach_m / spacing_m));
  for (const Eigen::Vector2d& point : path) {
    const Eigen::Vector2d at = (point - origin) / spacing_m;
    const int column = static_cast<int>(std::floor(at.x()));
    const int row = static_cast<int>(std::floor(at.y()));
    for (int r = std::max(0, row - reach); r <= std::min(rows - 1, row + reach); ++r) {
      for (int c = std::max(0, column - reach); c <= std::min(columns - 1, column + reach); ++c) {
        const Eigen::Vector2d center = origin + spacing_m * Eigen::Vector2d(c + 0.5, r + 0.5);
        if ((center - point).squaredNorm() <= reach_m * reach_m) {
          reachable[static_cast<std::size_t>(r) * columns + c] = true;
        }
      }
    }
  }
  return reachable;
}

}  // namespace

Lattice::Lattice(const Site& site, int floor, double spacing_m, double reach_m)
    : spacing_m_(spacing_m) {
  std::vector<Eigen::Vector2d> path;
  for (const SurveyPoint& point : site.path) {
    if (point.floor == floor) path.push_back(point.position_m);
  }
  if (path.empty()) return;
  Eigen::Vector2d low = path.front(), high = path.front();
  for (const Eigen::Vector2d& point : path) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  low.array() -= reach_m;
  high.array() += reach_m;
  columns_ = static_cast<int>(std::ceil((high.x() - low.x()) / spacing_m));
  rows_ = static_cast<int>(std::ceil((high.y() - low.y()) / spacing_m));
  const std::vector<bool> reachable = Reachable(path, low, spacing_m, columns_, rows_, reach_m);
  const std::vector<bool> surveyed = Reachable(path, low, spacing_m, columns_, rows_, spacing_m);
  const Floor* plan = site.building.FindFloor(floor);
  index_.assign(reachable.size(), kNoCell);
  for (std::size_t i = 0; i < reachable.size(); ++i) {
    if (!reachable[i]) continue;
    const int column = static_cast<int>(i) % columns_;
    const int row = static_cast<int>(i) / columns_;
    const Eigen::Vector2d center = low + spacing_m * Eigen::Vector2d(column + 0.5, row + 0.5);
    const bool outside =
        plan != nullptr && !plan->outline.empty() && !InsidePolygons(plan->outline, center);
    if (outside && !surveyed[i]) continue;
    index_[i] = static_cast<std::int32_t>(centers_m_.size());
    centers_m_.push_back(center);
    column_.push_back(column);
    row_.push_back(row);
  }
}

}  // namespace walkgraph
