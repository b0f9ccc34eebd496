#include "factors/fingerprint.h"

#include <algorithm>
#include <cmath>

#include "data/angle.h"
#include "factors/cost.h"
#include "factors/loss.h"
#include "factors/map_look.h"

namespace walkgraph {
FingerprintFactor::FingerprintFactor(const RadioMap* map, MapSweep sweep, const LossSettings& loss,
                                     double growth_per_sigma)
    : map_(map),
      sweep_(std::move(sweep)),
      loss_(loss),
      growth_per_sigma_(growth_per_sigma),
      log_sigma_min_(std::log(map->sigma_min_db)) {
  set_num_residuals(readings() + 1);
  *mutable_parameter_block_sizes() = {2, 2, 1, 1};
}

bool FingerprintFactor::Evaluate(const double* const* blocks, double* residual,
                                 double** jacobians) const {
  const bool gradients = jacobians != nullptr;
  const MapLook look(*map_, growth_per_sigma_, blocks[0], blocks[1]);
  const FieldBasis& basis = look.basis();
  const double root_weight = std::sqrt(sweep_.weight);
  const Eigen::Vector2d ahead = DirectionOf(blocks[3][0]);
  double spread_nats = 0;
  Eigen::Vector2d spread_gradient = Eigen::Vector2d::Zero();
  int row = 0;
  for (const MapSweep::Reading& reading : sweep_.readings) {
    const ScalarValue mean = map_->EvaluateMean(reading.field, basis, gradients);
    const ScalarValue log_sigma = map_->EvaluateLogSigma(reading.field, basis, gradients);
    const double information =
        std::sqrt(double{reading.precision}) * std::exp(-log_sigma.value);  // 1/dB
    const BodyShadow shadow = map_->ShadowOn(reading.field, look.place(), ahead);
    const double whitened =
        (reading.rssi_dbm + blocks[2][0] - mean.value - shadow.value_db) * information;
    const RobustRow robust = ApplyLoss(loss_, whitened);
    residual[row] = root_weight * robust.value;
    spread_nats += log_sigma.value - log_sigma_min_;
    if (jacobians != nullptr) {
      const double slope = root_weight * robust.slope;
      spread_gradient += log_sigma.gradient;
      look.FillRow(jacobians, row,
                   -slope * (information * (mean.gradient + shadow.by_position) +
                             whitened * log_sigma.gradient));
      if (jacobians[2] != nullptr) jacobians[2][row] = slope * information;
      if (jacobians[3] != nullptr) jacobians[3][row] = -slope * information * shadow.by_heading;
    }
    ++row;
  }
  const CostRow spread(spread_nats, sweep_.weight);
  residual[row] = spread.value;
  if (jacobians != nullptr) {
    look.FillRow(jacobians, row, spread.slope * spread_gradient);
    if (jacobians[2] != nullptr) jacobians[2][row] = 0;
    if (jacobians[3] != nullptr) jacobians[3][row] = 0;
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
  const MapLook look(*map_, growth_per_sigma_, blocks[0], blocks[1]);
  const FieldBasis& basis = look.basis();
  auto [nats, gradient] = map_->Silence(basis);
  for (const MapSweep::Reading& reading : sweep_.readings) {
    const ScalarValue logit = map_->EvaluateLogitHear(reading.field, basis, gradients);
    nats -= logit.value;
    gradient -= logit.gradient;
  }
  const CostRow row(nats, weight());
  residual[0] = row.value;
  if (jacobians != nullptr) look.FillRow(jacobians, 0, row.slope * gradient);
  return true;
}

}  // namespace walkgraph
