#ifndef WALKGRAPH_SOLVERS_BASELINES_WALLS_H_
#define WALKGRAPH_SOLVERS_BASELINES_WALLS_H_

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "data/building.h"

namespace walkgraph {

// The edges of polygons, found by place: does a straight way run through one?
class Walls {
 public:
  explicit Walls(std::span<const Polygon> polygons);

  bool empty() const { return edges_.empty(); }
  // Whether the segment crosses an edge; touching one with an end is no crossing.
  bool Block(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const;

 private:
  struct Edge {
    Eigen::Vector2d a, b;
  };
  struct CellRange {
    int first_column, first_row, last_column, last_row;
  };
  CellRange CellsOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;

  std::vector<Edge> edges_;
  Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<std::size_t>> cells_;  // edges by square, row-major
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_WALLS_H_
