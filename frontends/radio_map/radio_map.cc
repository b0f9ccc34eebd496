#include "frontends/radio_map/radio_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace walkgraph {
namespace {

// The four cubic B-spline weights and derivatives (per knot) at fraction t of a knot interval.
void CubicWeights(double t, std::array<double, 4>& weight, std::array<double, 4>& derivative) {
  const double u = 1.0 - t;
  weight = {u * u * u / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
            (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0, t * t * t / 6.0};
  derivative = {-u * u / 2.0, (3.0 * t * t - 4.0 * t) / 2.0, (4.0 * u - 3.0 * u * u) / 2.0,
                t * t / 2.0};
}

}  // namespace

AxisBasis EvaluateAxis(double coordinate, int count) {
  const double low = 1.0;
  const double high = static_cast<double>(count) - 2.0;
  // A comparison that is false for NaN would let it through to the cast below.
  const double inside = coordinate >= low ? std::min(coordinate, high) : low;
  const int cell = std::min(static_cast<int>(inside), count - 3);
  AxisBasis basis{cell - 1, {}, {}};
  CubicWeights(inside - cell, basis.weight, basis.derivative);
  if (inside != coordinate) basis.derivative = {};
  return basis;
}

FieldBasis EvaluateBasis(const FieldGrid& grid, const Eigen::Vector2d& position_m) {
  const double h = grid.spacing_m;
  const AxisBasis x = EvaluateAxis((position_m.x() - grid.origin_m.x()) / h, grid.columns);
  const AxisBasis y = EvaluateAxis((position_m.y() - grid.origin_m.y()) / h, grid.rows);
  FieldBasis basis;
  basis.column = x.first;
  basis.row = y.first;
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) {
      basis.weight[4 * r + c] = y.weight[r] * x.weight[c];
      basis.d_dx[4 * r + c] = y.weight[r] * x.derivative[c] / h;
      basis.d_dy[4 * r + c] = y.derivative[r] * x.weight[c] / h;
    }
  }
  return basis;
}

ScalarValue EvaluateField(const FieldGrid& grid, const std::vector<float>& control_values,
                          const FieldBasis& basis) {
  ScalarValue result;
  for (int r = 0; r < 4; ++r) {
    const auto line =
        static_cast<std::size_t>(basis.row + r) * static_cast<std::size_t>(grid.columns) +
        static_cast<std::size_t>(basis.column);
    for (int c = 0; c < 4; ++c) {
      const int k = 4 * r + c;
      const double control = control_values[line + static_cast<std::size_t>(c)];
      result.value += basis.weight[k] * control;
      result.gradient += Eigen::Vector2d(basis.d_dx[k], basis.d_dy[k]) * control;
    }
  }
  return result;
}

int RadioMap::FindField(std::uint32_t transmitter) const {
  const auto it = std::lower_bound(
      fields.begin(), fields.end(), transmitter,
      [](const TransmitterField& field, std::uint32_t key) { return field.transmitter < key; });
  if (it == fields.end() || it->transmitter != transmitter) return -1;
  return static_cast<int>(it - fields.begin());
}

namespace {

using Row = Eigen::Array4d;
using RowMap = Eigen::Map<const Row>;

// Products of control values with the weights and, for the gradient, their derivatives, summed over
// the rows.
struct RowSums {
  Row value = Row::Zero(), d_dx = Row::Zero(), d_dy = Row::Zero();

  template <bool kGradient>
  void Add(const FieldBasis& basis, int r, const Row& deviation) {
    value += RowMap(basis.weight.data() + std::ptrdiff_t{4} * r) * deviation;
    if constexpr (kGradient) {
      d_dx += RowMap(basis.d_dx.data() + std::ptrdiff_t{4} * r) * deviation;
      d_dy += RowMap(basis.d_dy.data() + std::ptrdiff_t{4} * r) * deviation;
    }
  }
};

// Sums deviations from the background: the weights add up to one and their derivatives to zero, so
// that a control point outside the field's rectangle adds nothing.
template <bool kGradient>
ScalarValue Interpolate(const RadioMap::TransmitterField& f, const std::vector<float>& values,
                        float background, const FieldBasis& basis) {
  const int first_row = std::max(0, f.row - basis.row);
  const int last_row = std::min(4, f.row + f.rows - basis.row);
  const int first_column = std::max(0, f.column - basis.column);
  const int last_column = std::min(4, f.column + f.columns - basis.column);
  if (first_column >= last_column) return {background, Eigen::Vector2d::Zero()};
  RowSums sums;
  for (int r = first_row; r < last_row; ++r) {
    const std::ptrdiff_t line =
        static_cast<std::ptrdiff_t>(basis.row + r - f.row) * f.columns + basis.column - f.column;
    Row deviation = Row::Zero();
    if (last_column - first_column == 4) {
      const Eigen::Map<const Eigen::Array4f> window(values.data() + line);
      deviation = window.cast<double>() - background;
    } else {
      for (int c = first_column; c < last_column; ++c) {
        deviation[c] = static_cast<double>(values[static_cast<std::size_t>(line + c)]) - background;
      }
    }
    sums.Add<kGradient>(basis, r, deviation);
  }
  return {background + sums.value.sum(), {sums.d_dx.sum(), sums.d_dy.sum()}};
}

ScalarValue Interpolate(const RadioMap::TransmitterField& f, const std::vector<float>& values,
                        float background, const FieldBasis& basis, bool gradient) {
  return gradient ? Interpolate<true>(f, values, background, basis)
                  : Interpolate<false>(f, values, background, basis);
}

}  // namespace

ScalarValue RadioMap::EvaluateMean(int field, const FieldBasis& basis, bool gradient) const {
  const TransmitterField& f = fields[static_cast<std::size_t>(field)];
  return Interpolate(f, f.mean_dbm, f.background_mean_dbm, basis, gradient);
}

ScalarValue RadioMap::EvaluateLogSigma(int field, const FieldBasis& basis, bool gradient) const {
  const TransmitterField& f = fields[static_cast<std::size_t>(field)];
  return Interpolate(f, f.log_sigma, f.background_log_sigma, basis, gradient);
}

ScalarValue RadioMap::EvaluateLogitHear(int field, const FieldBasis& basis, bool gradient) const {
  const TransmitterField& f = fields[static_cast<std::size_t>(field)];
  return Interpolate(f, f.logit_hear, f.background_logit_hear, basis, gradient);
}

FieldValue RadioMap::Evaluate(int field, const FieldBasis& basis) const {
  const ScalarValue mean = EvaluateMean(field, basis);
  const ScalarValue log_sigma = EvaluateLogSigma(field, basis);
  const ScalarValue logit = EvaluateLogitHear(field, basis);
  return {mean.value,    log_sigma.value,    logit.value,
          mean.gradient, log_sigma.gradient, logit.gradient};
}

FieldValue RadioMap::EvaluateValue(int field, const FieldBasis& basis) const {
  FieldValue value;
  value.mean_dbm = EvaluateMean(field, basis, false).value;
  value.log_sigma = EvaluateLogSigma(field, basis, false).value;
  value.logit_hear = EvaluateLogitHear(field, basis, false).value;
  return value;
}

BodyShadow RadioMap::ShadowOn(int field, const Eigen::Vector2d& position_m,
                              const Eigen::Vector2d& ahead) const {
  if (body_shadow_db == 0) return {};
  const auto source = fields[static_cast<std::size_t>(field)].source_m.cast<double>();
  return ShadowOf(body_shadow_db, BearingOf(source, position_m), ahead);
}

}  // namespace walkgraph
