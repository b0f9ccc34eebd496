#include "frontends/radio_map/radio_map.h"

#include <algorithm>
#include <cmath>

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

// Splits a coordinate (in knots) into the first of its four control points and the fraction behind
// the second; `scale` becomes 0 where the coordinate had to be clamped.
int Locate(double knots, int count, double* fraction, double* scale) {
  const double low = 1.0;
  const double high = static_cast<double>(count) - 2.0;
  // A comparison that is false for NaN would let it through to the cast below.
  const double inside = knots >= low ? std::min(knots, high) : low;
  *scale = inside == knots ? 1.0 : 0.0;
  const int cell = std::min(static_cast<int>(inside), count - 3);
  *fraction = inside - cell;
  return cell - 1;
}

}  // namespace

FieldBasis EvaluateBasis(const FieldGrid& grid, const Eigen::Vector2d& position_m) {
  FieldBasis basis;
  double tx, ty, scale_x, scale_y;
  const double h = grid.spacing_m;
  basis.column = Locate((position_m.x() - grid.origin_m.x()) / h, grid.columns, &tx, &scale_x);
  basis.row = Locate((position_m.y() - grid.origin_m.y()) / h, grid.rows, &ty, &scale_y);
  std::array<double, 4> wx, wy, dx, dy;
  CubicWeights(tx, wx, dx);
  CubicWeights(ty, wy, dy);
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) {
      basis.weight[4 * r + c] = wy[r] * wx[c];
      basis.d_dx[4 * r + c] = wy[r] * dx[c] * scale_x / h;
      basis.d_dy[4 * r + c] = dy[r] * wx[c] * scale_y / h;
    }
  }
  return basis;
}

int RadioMap::FindField(std::uint32_t transmitter) const {
  const auto it = std::lower_bound(
      fields.begin(), fields.end(), transmitter,
      [](const TransmitterField& field, std::uint32_t key) { return field.transmitter < key; });
  if (it == fields.end() || it->transmitter != transmitter) return -1;
  return static_cast<int>(it - fields.begin());
}

namespace {

// Calls visit(k, index) for every control point of the basis inside the field's rectangle: k counts
// the 16 of the basis, index those of the field.
template <typename Visit>
void ForControls(const RadioMap::TransmitterField& f, const FieldBasis& basis, Visit&& visit) {
  const int first_row = std::max(0, f.row - basis.row);
  const int last_row = std::min(4, f.row + f.rows - basis.row);
  const int first_column = std::max(0, f.column - basis.column);
  const int last_column = std::min(4, f.column + f.columns - basis.column);
  for (int r = first_row; r < last_row; ++r) {
    const int line = (basis.row + r - f.row) * f.columns + basis.column - f.column;
    for (int c = first_column; c < last_column; ++c) {
      visit(static_cast<std::size_t>(4 * r + c), static_cast<std::size_t>(line + c));
    }
  }
}

}  // namespace

// Both evaluate deviations from the background: the weights sum to one and their derivatives to
// zero, so a control point outside the rectangle adds nothing.
FieldValue RadioMap::Evaluate(int field, const FieldBasis& basis) const {
  const TransmitterField& f = fields[static_cast<std::size_t>(field)];
  FieldValue value{f.background_mean_dbm, f.background_log_sigma, f.background_logit_hear};
  ForControls(f, basis, [&](std::size_t k, std::size_t at) {
    const double mean = f.mean_dbm[at] - f.background_mean_dbm;
    const double log_sigma = f.log_sigma[at] - f.background_log_sigma;
    const double logit = f.logit_hear[at] - f.background_logit_hear;
    const Eigen::Vector2d slope(basis.d_dx[k], basis.d_dy[k]);
    value.mean_dbm += basis.weight[k] * mean;
    value.log_sigma += basis.weight[k] * log_sigma;
    value.logit_hear += basis.weight[k] * logit;
    value.d_mean += slope * mean;
    value.d_log_sigma += slope * log_sigma;
    value.d_logit_hear += slope * logit;
  });
  return value;
}

FieldValue RadioMap::EvaluateValue(int field, const FieldBasis& basis) const {
  const TransmitterField& f = fields[static_cast<std::size_t>(field)];
  FieldValue value{f.background_mean_dbm, f.background_log_sigma, f.background_logit_hear};
  ForControls(f, basis, [&](std::size_t k, std::size_t at) {
    value.mean_dbm += basis.weight[k] * (f.mean_dbm[at] - f.background_mean_dbm);
    value.log_sigma += basis.weight[k] * (f.log_sigma[at] - f.background_log_sigma);
    value.logit_hear += basis.weight[k] * (f.logit_hear[at] - f.background_logit_hear);
  });
  return value;
}

double RadioMap::Silence(const FieldBasis& basis, Eigen::Vector2d* gradient) const {
  double value = 0;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) {
      const int k = 4 * r + c;
      const double control =
          silence_nats[static_cast<std::size_t>((basis.row + r) * grid.columns + basis.column + c)];
      value += basis.weight[k] * control;
      slope += Eigen::Vector2d(basis.d_dx[k], basis.d_dy[k]) * control;
    }
  }
  if (gradient != nullptr) *gradient = slope;
  return value;
}

}  // namespace walkgraph
