#include "graph/check_settings.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace walkgraph {
namespace {

void CheckPositive(const char* name, double value) {
  if (std::isfinite(value) && value > 0) return;
  throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) +
                              ", expected a positive number");
}

void CheckNotNegative(const char* name, double value) {
  if (value >= 0) return;
  throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) +
                              ", expected a positive number or 0");
}

}  // namespace

void CheckSettings(const FactorSettings& s) {
  CheckPositive("step.sigma_along_m", s.step.sigma_along_m);
  CheckPositive("step.sigma_across_m", s.step.sigma_across_m);
  CheckNotNegative("step.tread_m", s.step.tread_m);
  CheckPositive("heading_increment.sigma_rad_per_sqrt_s", s.heading_increment.sigma_rad_per_sqrt_s);
  CheckPositive("heading_increment.unmeasured_rad_per_sqrt_s",
                s.heading_increment.unmeasured_rad_per_sqrt_s);
  CheckPositive("absolute_heading.sigma_rad", s.absolute_heading.sigma_rad);
  CheckPositive("standing.sigma_mps", s.standing.sigma_mps);
  CheckPositive("standing.unseen_mps", s.standing.unseen_mps);
  if (s.fingerprint.loss.kind == LossKind::kTruncated) {
    throw std::invalid_argument(
        "fingerprint.loss is truncated, expected none, huber or cauchy: every reading has its own");
  }
  CheckNotNegative("magnetic.correlation_s", s.magnetic.correlation_s);
  CheckPositive("gyro_bias.prior_sigma_radps", s.gyro_bias.prior_sigma_radps);
  CheckPositive("gyro_bias.walk_radps_per_sqrt_s", s.gyro_bias.walk_radps_per_sqrt_s);
  CheckPositive("gyro_bias.knot_s", s.gyro_bias.knot_s);
  CheckPositive("heading_offset.prior_sigma_rad", s.heading_offset.prior_sigma_rad);
  CheckPositive("heading_offset.walk_rad_per_sqrt_s", s.heading_offset.walk_rad_per_sqrt_s);
  CheckPositive("heading_offset.knot_s", s.heading_offset.knot_s);
  CheckPositive("step_scale.prior_sigma", s.step_scale.prior_sigma);
  CheckPositive("step_scale.walk_per_sqrt_s", s.step_scale.walk_per_sqrt_s);
  CheckPositive("step_scale.knot_s", s.step_scale.knot_s);
  CheckPositive("map_error.correlation_m", s.map_error.correlation_m);
  CheckPositive("map_error.correlation_s", s.map_error.correlation_s);
  CheckPositive("map_error.knot_s", s.map_error.knot_s);
  CheckPositive("rssi_offset.prior_sigma_db", s.rssi_offset.prior_sigma_db);
  CheckPositive("barometric.sigma_m", s.barometric.sigma_m);
  CheckPositive("barometric_offset.prior_sigma_m", s.barometric_offset.prior_sigma_m);
  CheckPositive("barometric_offset.walk_m_per_sqrt_s", s.barometric_offset.walk_m_per_sqrt_s);
  CheckPositive("barometric_offset.knot_s", s.barometric_offset.knot_s);
  CheckPositive("level.sigma_m", s.level.sigma_m);
  CheckPositive("level.climb_m_per_sqrt_s", s.level.climb_m_per_sqrt_s);
  CheckPositive("area.reach_m", s.area.reach_m);
  CheckPositive("area.sigma_m", s.area.sigma_m);
  CheckPositive("prior.position_sigma_m", s.prior.position_sigma_m);
}

}  // namespace walkgraph
