#ifndef WALKGRAPH_SOLVERS_BASELINES_DSFF_CELLS_H_
#define WALKGRAPH_SOLVERS_BASELINES_DSFF_CELLS_H_

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "solvers/baselines/reference_points.h"

namespace walkgraph {

// The location cells of DSFF: the squares of one lattice per floor, numbered through.
class DsffCells {
 public:
  struct FloorCells {
    int floor = 0;
    double height_m = 0;
    std::size_t begin = 0;  // number of its first cell
    ReferencePoints points;
  };

  // Floors without a survey path have no cells and are left out.
  DsffCells(const Site& site, const std::vector<int>& floors,
            const ReferencePointSettings& settings);
  // One floor of given points at height 0.
  explicit DsffCells(ReferencePoints points);

  std::size_t size() const { return floor_of_.size(); }
  double spacing_m() const { return floors_.front().points.spacing_m(); }
  const std::vector<FloorCells>& floors() const { return floors_; }
  const FloorCells& FloorOf(int cell) const {
    return floors_[floor_of_[static_cast<std::size_t>(cell)]];
  }
  Eigen::Vector2d PositionOf(int cell) const {
    const FloorCells& floor = FloorOf(cell);
    return floor.points.positions_m()[static_cast<std::size_t>(cell) - floor.begin];
  }
  // The cell `offset` away on the floor with index `to`, or -1. Between floors, whose lattices need
  // not be aligned, the nearest.
  int Move(int cell, const ReferencePoints::Cell& offset, std::size_t to) const;

 private:
  std::vector<FloorCells> floors_;
  std::vector<std::size_t> floor_of_;  // index of each cell's floor
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_DSFF_CELLS_H_
