#ifndef WALKGRAPH_SOLVERS_BASELINES_REFERENCE_POINTS_H_
#define WALKGRAPH_SOLVERS_BASELINES_REFERENCE_POINTS_H_

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "frontends/radio_map/site.h"

namespace walkgraph {

enum class ReferenceArea : std::uint8_t {
  kSurveyed,  // within reach of a survey path
  kWalkable,  // inside the floor's outline and outside its obstacles; surveyed where none is known
};
inline constexpr std::array<std::string_view, 2> kReferenceAreaNames = {"surveyed", "walkable"};

struct ReferencePointSettings {
  ReferenceArea area = ReferenceArea::kSurveyed;
  double spacing_m = 3;
  double reach_m = 3;
};

template <typename Visitor>
void Visit(Visitor& v, ReferencePointSettings& s) {
  v.Field("area", s.area, "where a person may be: surveyed (paths and their reach) or walkable");
  v.Field("spacing_m", s.spacing_m, "distance of neighbouring reference points, m");
  v.Field("reach_m", s.reach_m, "a point this near a survey path is in the surveyed area, m");
}

// The states of the discrete methods: points of a square lattice on one floor.
class ReferencePoints {
 public:
  struct Cell {
    int column = 0, row = 0;
    bool operator==(const Cell&) const = default;
  };

  // The lattice begins half a spacing inside the floor's bounding box (the survey's, where the
  // building does not know the floor). Empty where nothing was surveyed on the floor.
  // Throws std::invalid_argument unless spacing and reach are positive.
  ReferencePoints(const Site& site, int floor, const ReferencePointSettings& settings);
  // Exactly the given cells of a lattice whose cell (0, 0) lies at `origin_m`; negative ones are
  // not allowed.
  ReferencePoints(std::vector<Cell> cells, const Eigen::Vector2d& origin_m, double spacing_m);

  std::size_t size() const { return positions_m_.size(); }
  bool empty() const { return positions_m_.empty(); }
  double spacing_m() const { return spacing_m_; }
  std::span<const Eigen::Vector2d> positions_m() const { return positions_m_; }
  const Cell& cell(std::size_t i) const { return cells_[i]; }
  // The cell of the lattice nearest to a position, with or without a point.
  Cell CellAt(const Eigen::Vector2d& position_m) const {
    const Eigen::Vector2d at = (position_m - origin_m_) / spacing_m_;
    return {static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))};
  }
  // The point at a cell of the lattice, or -1.
  int IndexAt(Cell cell) const;
  // Calls visit(int index) for the points within `radius_m` of a position (ends included),
  // ascending.
  template <typename Visitor>
  void ForNear(const Eigen::Vector2d& position_m, double radius_m, Visitor visit) const;

 private:
  void Place(std::vector<Cell> cells);

  Eigen::Vector2d origin_m_;
  double spacing_m_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Cell> cells_;  // by row, then column
  std::vector<Eigen::Vector2d> positions_m_;
  std::vector<int> index_;  // of each cell of the lattice, row-major; -1 where there is no point
};

// Calls visit(cell) for the cells within `radius_m` of a position of the lattice whose cell (0, 0)
// lies at `origin_m`, by row, then column; cells may be negative.
template <typename Visitor>
void ForLatticeCellsNear(const Eigen::Vector2d& position_m, double radius_m, double spacing_m,
                         const Eigen::Vector2d& origin_m, Visitor visit) {
  const Eigen::Vector2d at = (position_m - origin_m) / spacing_m;
  const double radius = radius_m / spacing_m;
  for (int r = static_cast<int>(std::ceil(at.y() - radius)); r <= at.y() + radius; ++r) {
    for (int c = static_cast<int>(std::ceil(at.x() - radius)); c <= at.x() + radius; ++c) {
      if ((Eigen::Vector2d(c, r) - at).squaredNorm() > radius * radius) continue;
      visit(ReferencePoints::Cell{c, r});
    }
  }
}

template <typename Visitor>
void ReferencePoints::ForNear(const Eigen::Vector2d& position_m, double radius_m,
                              Visitor visit) const {
  ForLatticeCellsNear(position_m, radius_m, spacing_m_, origin_m_, [&](const Cell& cell) {
    if (const int index = IndexAt(cell); index >= 0) visit(index);
  });
}

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_REFERENCE_POINTS_H_
