#include "frontends/radio_map/field_lattice.h"

#include <algorithm>
#include <cstddef>

namespace walkgraph {

FieldLattice::FieldLattice(const FieldGrid& grid, const Eigen::Vector2d& first_m, double spacing_m,
                           int side) {
  const Eigen::Vector2d first = (first_m - grid.origin_m) / grid.spacing_m;
  const double step = spacing_m / grid.spacing_m;
  x_ = MakeAxis(first.x(), step, side, grid.columns);
  y_ = MakeAxis(first.y(), step, side, grid.rows);
}

FieldLattice::Axis FieldLattice::MakeAxis(double first, double step, int side, int controls) {
  Axis axis;
  axis.weight.resize(4, side);
  for (int i = 0; i < side; ++i) {
    const AxisBasis basis = EvaluateAxis(first + step * i, controls);
    axis.begin.push_back(basis.first);
    axis.weight.col(i) = Eigen::Map<const Eigen::Vector4d>(basis.weight.data()).cast<float>();
  }
  axis.first_control = axis.begin.front();
  axis.controls = axis.begin.back() + 4 - axis.first_control;
  for (int& begin : axis.begin) begin -= axis.first_control;
  return axis;
}

Eigen::MatrixXf FieldLattice::Combine(const Eigen::MatrixXf& columns, const Axis& axis) {
  Eigen::MatrixXf sums(columns.rows(), axis.weight.cols());
  for (Eigen::Index i = 0; i < sums.cols(); ++i) {
    const Eigen::Index first = axis.begin[static_cast<std::size_t>(i)];
    sums.col(i) =
        axis.weight(0, i) * columns.col(first) + axis.weight(1, i) * columns.col(first + 1) +
        axis.weight(2, i) * columns.col(first + 2) + axis.weight(3, i) * columns.col(first + 3);
  }
  return sums;
}

Eigen::ArrayXf FieldLattice::Evaluate(const ControlValues& controls) const {
  const Eigen::Index side = x_.weight.cols();
  // The window of controls that matter, as deviations from the background.
  const int first_column = std::max(x_.first_control, controls.column);
  const int end_column =
      std::min(x_.first_control + x_.controls, controls.column + controls.columns);
  const int first_row = std::max(y_.first_control, controls.row);
  const int end_row = std::min(y_.first_control + y_.controls, controls.row + controls.rows);
  if (first_column >= end_column || first_row >= end_row) {
    return Eigen::ArrayXf::Constant(side * side, controls.background);
  }
  Eigen::MatrixXf window = Eigen::MatrixXf::Zero(y_.controls, x_.controls);
  using RowMajor = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const RowMajor> all(controls.values.data(), controls.rows, controls.columns);
  const int columns = end_column - first_column, rows = end_row - first_row;
  window.block(first_row - y_.first_control, first_column - x_.first_control, rows, columns) =
      all.block(first_row - controls.row, first_column - controls.column, rows, columns).array() -
      controls.background;
  const Eigen::MatrixXf by_row = Combine(window, x_).transpose();
  return Combine(by_row, y_).reshaped().array() + controls.background;
}

}  // namespace walkgraph
