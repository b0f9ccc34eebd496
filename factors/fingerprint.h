#ifndef WALKGRAPH_FACTORS_FINGERPRINT_H_
#define WALKGRAPH_FACTORS_FINGERPRINT_H_

#include <ceres/sized_cost_function.h>

#include <Eigen/Core>
#include <string_view>
#include <utility>
#include <vector>

#include "factors/cost_row.h"
#include "factors/map_sweeps.h"
#include "factors/settings.h"
#include "frontends/radio_map/radio_map.h"

namespace walkgraph {

// The likelihood of a scan has two halves, one factor type each. Both look the map up at
//   u = x(t) + r(x) e,   x position, e map error, r its growth away from the survey (see MapLook),
// and both are weighted by w = min(1, N_eff / N): the N readings of a scan are not independent.
// A term that is no square becomes a row of its own (see factors/cost_row.h), whose offset is taken
// out of the posterior again (see CostConstant).

// How strong the readings of (part of) a scan are. With m, s the map's mean and spread, s_min the
// map's smallest, z_i the readings (dBm), p_i their precision (mostly 1), b the device's offset
// (dB), h the direction of walking and a t_i(u) amplitude and bearing of the body's shadow (see
// body_shadow.h), row i and the last row are
//   sqrt(w) rho(sqrt(p_i) (z_i + b - m_i(u) - a h . t_i(u)) / s_i(u)),
//   sqrt(w) sqrt(2 sum_i log(s_i(u) / s_min) + kRowOffset),
// so that no optimum can flee to where the map knows nothing. rho is the loss, reading by reading.
// Blocks: position, map error, RSSI offset, heading.
class FingerprintFactor : public ceres::CostFunction {
 public:
  static constexpr std::string_view kName = "fingerprint";

  // `map` must outlive the factor; `growth_per_sigma` (1/m) as in MapLook.
  FingerprintFactor(const RadioMap* map, MapSweep sweep, const LossSettings& loss,
                    double growth_per_sigma);

  bool Evaluate(const double* const* blocks, double* residual, double** jacobians) const override;

  int readings() const { return static_cast<int>(sweep_.readings.size()); }
  double weight() const { return sweep_.weight; }
  // Nats that the rows cost beyond the likelihood they stand for.
  double CostConstant() const { return 0.5 * sweep_.weight * kRowOffset; }
  // Of the weighted densities, with spread s_min: the last row holds the rest.
  double LogNormaliser() const;

 private:
  const RadioMap* map_;
  MapSweep sweep_;
  LossSettings loss_;
  double growth_per_sigma_;
  double log_sigma_min_;
};

// Which transmitters a scan heard and which it did not. With p_j the probability of hearing
// transmitter j and H those heard,
//   c(u) = -sum_{j in H} log p_j - sum_{j not in H} log(1 - p_j) = S(u) - sum_{j in H} logit
//   p_j(u),
// S the map's silence; r = sqrt(h w) sqrt(2 c + kRowOffset). c >= 0 although S is a spline of its
// own (h is the map's hear_weight): softplus is convex, so that the spline of softplus(logit) lies
// above softplus of the spline. Blocks: position, map error.
class HearingFactor : public ceres::SizedCostFunction<1, 2, 2> {
 public:
  static constexpr std::string_view kName = "hearing";

  // `map` must outlive the factor; `sweep` is the whole scan; `growth_per_sigma` as above.
  HearingFactor(const RadioMap* map, MapSweep sweep, double growth_per_sigma)
      : map_(map), sweep_(std::move(sweep)), growth_per_sigma_(growth_per_sigma) {}

  bool Evaluate(const double* const* blocks, double* residual, double** jacobians) const override;

  double weight() const { return sweep_.weight * map_->hear_weight; }
  double CostConstant() const { return 0.5 * weight() * kRowOffset; }

 private:
  const RadioMap* map_;
  MapSweep sweep_;
  double growth_per_sigma_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_FINGERPRINT_H_
