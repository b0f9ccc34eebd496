#include "solvers/baselines/walls.h"

#include <algorithm>
#include <cmath>

namespace walkgraph {
namespace {

constexpr double kCellM = 4;  // about the length of an edge and of a way between two epochs

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Do two segments cross in their insides?
bool SegmentsCross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                   const Eigen::Vector2d& d) {
  const double side_c = Cross(b - a, c - a), side_d = Cross(b - a, d - a);
  const double side_a = Cross(d - c, a - c), side_b = Cross(d - c, b - c);
  return side_c * side_d < 0 && side_a * side_b < 0;
}

}  // namespace

Walls::Walls(std::span<const Polygon> polygons) {
  for (const Polygon& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      edges_.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
    }
  }
  if (edges_.empty()) return;
  origin_m_ = edges_.front().a;
  Eigen::Vector2d high = origin_m_;
  for (const Edge& edge : edges_) {
    origin_m_ = origin_m_.cwiseMin(edge.a);
    high = high.cwiseMax(edge.a);
  }
  columns_ = static_cast<int>((high - origin_m_).x() / kCellM) + 1;
  rows_ = static_cast<int>((high - origin_m_).y() / kCellM) + 1;
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const CellRange range = CellsOf(edges_[e].a, edges_[e].b);
    for (int r = range.first_row; r <= range.last_row; ++r) {
      for (int c = range.first_column; c <= range.last_column; ++c) {
        cells_[static_cast<std::size_t>(r * columns_ + c)].push_back(e);
      }
    }
  }
}

Walls::CellRange Walls::CellsOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
  const Eigen::Vector2d low = (a.cwiseMin(b) - origin_m_) / kCellM;
  const Eigen::Vector2d high = (a.cwiseMax(b) - origin_m_) / kCellM;
  return {std::max(0, static_cast<int>(std::floor(low.x()))),
          std::max(0, static_cast<int>(std::floor(low.y()))),
          std::min(columns_ - 1, static_cast<int>(std::floor(high.x()))),
          std::min(rows_ - 1, static_cast<int>(std::floor(high.y())))};
}

bool Walls::Block(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const {
  const CellRange range = CellsOf(from_m, to_m);
  for (int r = range.first_row; r <= range.last_row; ++r) {
    for (int c = range.first_column; c <= range.last_column; ++c) {
      for (const std::size_t e : cells_[static_cast<std::size_t>(r * columns_ + c)]) {
        if (SegmentsCross(from_m, to_m, edges_[e].a, edges_[e].b)) return true;
      }
    }
  }
  return false;
}

}  // namespace walkgraph
