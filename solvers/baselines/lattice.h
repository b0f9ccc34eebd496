#ifndef WALKGRAPH_SOLVERS_BASELINES_LATTICE_H_
#define WALKGRAPH_SOLVERS_BASELINES_LATTICE_H_

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "frontends/radio_map/site.h"

namespace walkgraph {

// Square cells over the part of the given floors where a walk may be: inside the outline (the
// bounding box of everything surveyed where there is none) and within `reach_m` of a survey path,
// for what lies farther off no method can know. Floors lie above one another in one frame: a cell
// is a place on the plan, allowed where one of them allows it.
class Lattice {
 public:
  Lattice(const Site& site, const std::vector<int>& floors, double spacing_m, double reach_m);

  static constexpr std::int32_t kNoCell = -1;

  double spacing_m() const { return spacing_m_; }
  // Centres of the allowed cells.
  const std::vector<Eigen::Vector2d>& centers_m() const { return centers_m_; }
  std::size_t size() const { return centers_m_.size(); }
  // The allowed cell `columns` to the right of and `rows` above another, or kNoCell.
  std::int32_t Neighbour(std::int32_t cell, int columns, int rows) const {
    const int column = column_[static_cast<std::size_t>(cell)] + columns;
    const int row = row_[static_cast<std::size_t>(cell)] + rows;
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return kNoCell;
    return index_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }

 private:
  // Of a square of the bounding box, whose lower left corner is `low`.
  Eigen::Vector2d Center(const Eigen::Vector2d& low, std::size_t square) const;

  double spacing_m_;
  int columns_ = 0, rows_ = 0;
  std::vector<std::int32_t> index_;  // of each square of the bounding box, row-major
  std::vector<Eigen::Vector2d> centers_m_;
  std::vector<int> column_, row_;  // of each allowed cell
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_LATTICE_H_
