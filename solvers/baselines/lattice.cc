#include "solvers/baselines/lattice.h"

#include <Eigen/Geometry>
#include <algorithm>
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

Lattice::Lattice(const Site& site, const std::vector<int>& floors, double spacing_m, double reach_m)
    : spacing_m_(spacing_m) {
  std::vector<std::vector<Eigen::Vector2d>> paths;
  Eigen::AlignedBox2d box;
  for (const int floor : floors) {
    paths.emplace_back();
    for (const SurveyPoint& point : site.path) {
      if (point.floor != floor) continue;
      paths.back().push_back(point.position_m);
      box.extend(point.position_m);
    }
  }
  if (box.isEmpty()) return;
  const Eigen::Vector2d low = box.min().array() - reach_m;
  const Eigen::Vector2d high = box.max().array() + reach_m;
  columns_ = static_cast<int>(std::ceil((high.x() - low.x()) / spacing_m));
  rows_ = static_cast<int>(std::ceil((high.y() - low.y()) / spacing_m));
  std::vector<bool> allowed(static_cast<std::size_t>(columns_) * rows_, false);
  for (std::size_t f = 0; f < floors.size(); ++f) {
    const std::vector<bool> reachable =
        Reachable(paths[f], low, spacing_m, columns_, rows_, reach_m);
    const std::vector<bool> surveyed =
        Reachable(paths[f], low, spacing_m, columns_, rows_, spacing_m);
    const Floor* plan = site.building.FindFloor(floors[f]);
    for (std::size_t i = 0; i < allowed.size(); ++i) {
      if (!reachable[i] || allowed[i]) continue;
      const bool outside = plan != nullptr && !plan->outline.empty() &&
                           !InsidePolygons(plan->outline, Center(low, i));
      allowed[i] = !outside || surveyed[i];
    }
  }
  index_.assign(allowed.size(), kNoCell);
  for (std::size_t i = 0; i < allowed.size(); ++i) {
    if (!allowed[i]) continue;
    index_[i] = static_cast<std::int32_t>(centers_m_.size());
    centers_m_.push_back(Center(low, i));
    column_.push_back(static_cast<int>(i) % columns_);
    row_.push_back(static_cast<int>(i) / columns_);
  }
}

Eigen::Vector2d Lattice::Center(const Eigen::Vector2d& low, std::size_t square) const {
  const int column = static_cast<int>(square) % columns_;
  const int row = static_cast<int>(square) / columns_;
  return low + spacing_m_ * Eigen::Vector2d(column + 0.5, row + 0.5);
}

}  // namespace walkgraph
