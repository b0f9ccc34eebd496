#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_FIELD_LATTICE_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_FIELD_LATTICE_H_

#include <Eigen/Core>
#include <vector>

#include "frontends/radio_map/radio_map.h"

namespace walkgraph {

// Control values inside a rectangle of a grid's control points, row-major, and the value of all
// others.
struct ControlValues {
  int column = 0, row = 0, columns = 0, rows = 0;
  const std::vector<float>& values;
  float background = 0;
};

// A square lattice of places, parallel to a grid, at all of which fields are evaluated at once: the
// spline of a lattice is that of its columns times that of its rows. Several times faster than one
// place after the other. In single precision.
class FieldLattice {
 public:
  // side x side places, the first of them (least x and y) at `first_m`.
  FieldLattice(const FieldGrid& grid, const Eigen::Vector2d& first_m, double spacing_m, int side);

  // The field at all places, row by row.
  Eigen::ArrayXf Evaluate(const ControlValues& controls) const;

 private:
  // The four weights of every place along one axis, and where its controls begin in the window.
  struct Axis {
    int first_control = 0;  // of the window, in the grid
    int controls = 0;       // of the window
    std::vector<int> begin;
    Eigen::Matrix4Xf weight;
  };
  static Axis MakeAxis(double first, double step, int side, int controls);
  // Weighted sums of four columns each.
  static Eigen::MatrixXf Combine(const Eigen::MatrixXf& columns, const Axis& axis);

  Axis x_, y_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_FIELD_LATTICE_H_
