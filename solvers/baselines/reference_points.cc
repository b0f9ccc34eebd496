#include "solvers/baselines/reference_points.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace walkgraph {
namespace {

using Cell = ReferencePoints::Cell;

struct Box {
  Eigen::Vector2d min_m, max_m;
};

const Floor* FindFloor(const Site& site, int number) {
  for (const Floor& floor : site.building.floors) {
    if (floor.number == number) return &floor;
  }
  return nullptr;
}

Box LatticeBox(const Floor* floor, const std::vector<Eigen::Vector2d>& path, double reach_m) {
  if (floor != nullptr && (floor->max_corner.array() > floor->min_corner.array()).all()) {
    return {floor->min_corner, floor->max_corner};
  }
  Box box{path.front(), path.front()};
  for (const Eigen::Vector2d& point : path) {
    box.min_m = box.min_m.cwiseMin(point);
    box.max_m = box.max_m.cwiseMax(point);
  }
  return {box.min_m.array() - reach_m, box.max_m.array() + reach_m};
}

bool IsWalkable(const Floor& floor, const Eigen::Vector2d& position) {
  return InsidePolygons(floor.outline, position) &&
         std::none_of(floor.obstacles.begin(), floor.obstacles.end(),
                      [&](const Polygon& shop) { return InsidePolygons({shop}, position); });
}

}  // namespace

ReferencePoints::ReferencePoints(const Site& site, int floor_number,
                                 const ReferencePointSettings& settings)
    : origin_m_(Eigen::Vector2d::Zero()), spacing_m_(settings.spacing_m) {
  if (!(settings.spacing_m > 0) || !(settings.reach_m > 0)) {
    throw std::invalid_argument("reference points need a positive spacing and reach");
  }
  std::vector<Eigen::Vector2d> path;
  for (const SurveyPoint& point : site.path) {
    if (point.floor == floor_number) path.push_back(point.position_m);
  }
  if (path.empty()) return;
  const Floor* floor = FindFloor(site, floor_number);
  const Box box = LatticeBox(floor, path, settings.reach_m);
  origin_m_ = box.min_m.array() + spacing_m_ / 2;
  const int columns = static_cast<int>(std::ceil((box.max_m - origin_m_).x() / spacing_m_));
  const int rows = static_cast<int>(std::ceil((box.max_m - origin_m_).y() / spacing_m_));

  std::vector<bool> inside(static_cast<std::size_t>(std::max(0, columns)) *
                           static_cast<std::size_t>(std::max(0, rows)));
  const auto at = [columns](const Cell& cell) {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(cell.column);
  };
  const bool walkable =
      settings.area == ReferenceArea::kWalkable && floor != nullptr && !floor->outline.empty();
  if (!walkable) {
    for (const Eigen::Vector2d& point : path) {
      ForLatticeCellsNear(point, settings.reach_m, spacing_m_, origin_m_, [&](const Cell& cell) {
        if (cell.column < 0 || cell.row < 0 || cell.column >= columns || cell.row >= rows) return;
        inside[at(cell)] = true;
      });
    }
  }
  std::vector<Cell> cells;
  for (Cell cell; cell.row < rows; ++cell.row) {
    for (cell.column = 0; cell.column < columns; ++cell.column) {
      const Eigen::Vector2d position =
          origin_m_ + spacing_m_ * Eigen::Vector2d(cell.column, cell.row);
      if (walkable ? IsWalkable(*floor, position) : inside[at(cell)]) cells.push_back(cell);
    }
  }
  Place(std::move(cells));
}

ReferencePoints::ReferencePoints(std::vector<Cell> cells, const Eigen::Vector2d& origin_m,
                                 double spacing_m)
    : origin_m_(origin_m), spacing_m_(spacing_m) {
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
    return std::tie(a.row, a.column) < std::tie(b.row, b.column);
  });
  Place(std::move(cells));
}

void ReferencePoints::Place(std::vector<Cell> cells) {
  cells_ = std::move(cells);
  for (const Cell& cell : cells_) {
    columns_ = std::max(columns_, cell.column + 1);
    rows_ = std::max(rows_, cell.row + 1);
    positions_m_.emplace_back(origin_m_ + spacing_m_ * Eigen::Vector2d(cell.column, cell.row));
  }
  index_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    index_[static_cast<std::size_t>(cells_[i].row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(cells_[i].column)] = static_cast<int>(i);
  }
}

int ReferencePoints::IndexAt(Cell cell) const {
  if (cell.column < 0 || cell.row < 0 || cell.column >= columns_ || cell.row >= rows_) return -1;
  return index_[static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(columns_) +
                static_cast<std::size_t>(cell.column)];
}

}  // namespace walkgraph
