#include "factors/fingerprint.h"

#include <algorithm>
#include <cmath>

#include "factors/cost.h"
#include "factors/loss.h"

namespace walkgraph {
namespace {

FieldBasis BasisAt(const RadioMap& map, const double* position, const double* map_error) {
  return EvaluateBasis(map.grid, {position[0] + map_error[0], position[1] + map_error[1]});
}

// Writes a row of the Jacobians by position and map error, which are the same.
void FillPositionRow(double** jacobians, int row, const Eigen::Vector2d& gradient) {
  for (const int block : {0, 1}) {
    if (jacobians[block] == nullptr) continue;
    jacobians[block][2 * row] = gradient.x();
    jacobians[block][2 * row + 1] = gradient.y();
  }
}

}  // namespace

FingerprintFactor::FingerprintFactor(const RadioMap* map, MapSweep sweep, const LossSettings& loss)
    : map_(map),
      sweep_(std::move(sweep)),
      loss_(loss),
      log_sigma_min_(std::log(map->sigma_min_db)) {
  set_num_residuals(readings() + 1);
  *mutable_parameter_block_sizes() = {2, 2, 1};
}

bool FingerprintFactor::Evaluate(const double* const* blocks, double* residual,
                                 double** jacobians) const {
  const bool gradients = jacobians != nullptr;
  const FieldBasis basis = BasisAt(*map_, blocks[0], blocks[1]);
  const double root_weight = std::sqrt(sweep_.weight);
  double spread_nats = 0;
  Eigen::Vector2d spread_gradient = Eigen::Vector2d::Zero();
  int row = 0;
  for (const MapSweep::Reading& reading : sweep_.readings) {
    const ScalarValue mean = map_->EvaluateMean(reading.field, basis, gradients);
    const ScalarValue log_sigma = map_->EvaluateLogSigma(reading.field, basis, gradients);
    const double information =
        std::sqrt(double{reading.precision}) * std::exp(-log_sigma.value);  // 1/dB
    const double whitened = (reading.rssi_dbm + blocks[2][0] - mean.value) * information;
    const RobustRow robust = ApplyLoss(loss_, whitened);
    residual[row] = root_weight * robust.value;
    spread_nats += log_sigma.value - log_sigma_min_;
    if (jacobians != nullptr) {
      const double slope = root_weight * robust.slope;
      spread_gradient += log_sigma.gradient;
      FillPositionRow(jacobians, row,
                      -slope * (information * mean.gradient + whitened * log_sigma.gradient));
      if (jacobians[2] != nullptr) jacobians[2][row] = slope * information;
    }
    ++row;
  }
  const CostRow spread(spread_nats, sweep_.weight);
  residual[row] = spread.value;
  if (jacobians != nullptr) {
    FillPositionRow(jacobians, row, spread.slope * spread_gradient);
    if (jacobians[2] != nullptr) jacobians[2][row] = 0;
  }
  return true;
}

double FingerprintFactor::LogNormaliser() const {
  double nats = readings() * GaussianLogNormaliser(map_->sigma_min_db);
  for (const MapSweep::Reading& reading : sweep_.readings)
    nats -= 0.5 * std::log(reading.precision);
  return sweep_.weight * nats;
}

bool HearingFactor::Evaluate(const double* const* blocks, double* residual,
                             double** jacobians) const {
  const bool gradients = jacobians != nullptr;
  const FieldBasis basis = BasisAt(*map_, blocks[0], blocks[1]);
  auto [nats, gradient] = map_->Silence(basis);
  for (const MapSweep::Reading& reading : sweep_.readings) {
    const ScalarValue logit = map_->EvaluateLogitHear(reading.field, basis, gradients);
    nats -= logit.value;
    gradient -= logit.gradient;
  }
  const CostRow row(nats, weight());
  residual[0] = row.value;
  if (jacobians != nullptr) FillPositionRow(jacobians, 0, row.slope * gradient);
  return true;
}

}  // namespace walkgraph
