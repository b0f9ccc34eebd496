#ifndef WALKGRAPH_SOLVERS_BASELINES_HIPE_EMISSION_H_
#define WALKGRAPH_SOLVERS_BASELINES_HIPE_EMISSION_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "frontends/radio_map/site.h"
#include "solvers/baselines/fingerprints.h"
#include "solvers/baselines/reference_points.h"
#include "solvers/baselines/weibull.h"

namespace walkgraph {

struct HipeEmissionSettings {
  double training_radius_m = 3;
  double weibull_shape = 0;
  double prior_readings = 4;
  double floor_probability = 1e-4;  // one chance in a hundred of hearing it, over 100 dB
  bool use_silence = true;
  bool use_effective_readings = true;
};

template <typename Visitor>
void Visit(Visitor& v, HipeEmissionSettings& s) {
  v.Field("training_radius_m", s.training_radius_m,
          "survey readings this near a reference point make its densities, m");
  v.Field("weibull_shape", s.weibull_shape,
          "shape of all Weibull densities; 0 takes the one with the pooled skewness of the floor");
  v.Field("prior_readings", s.prior_readings,
          "weight of the floor's pooled variance in that of a point, in readings");
  v.Field("floor_probability", s.floor_probability,
          "of a reading from an access point that was never heard near the point");
  v.Field("use_silence", s.use_silence,
          "use how often an access point is heard near the point (not in the paper)");
  v.Field("use_effective_readings", s.use_effective_readings,
          "weigh a scan by min(1, N_eff / N) as the graph does (the paper: independent readings)");
}

// Probability of a scan at every reference point: a Weibull density per access point and point.
class HipeEmission {
 public:
  // Trained on the Wi-Fi readings of the survey on one floor. Moments are kept only for the
  // `wanted` transmitters (indices into Site::transmitters); what is pooled comes from all.
  HipeEmission(const Site& site, int floor, const ReferencePoints& points,
               const std::vector<std::uint32_t>& wanted, double max_age_s,
               const HipeEmissionSettings& settings);

  // log p of a scan at each reference point, not weighted.
  std::vector<double> LogLikelihood(const SignalVector& scan) const;

  double shape() const { return shape_; }
  double pooled_sd_db() const { return pooled_sd_db_; }

 private:
  struct Cell;
  struct Density {
    int point = 0;
    Weibull weibull;
    double log_odds_heard = 0;  // of hearing the access point in a scan
  };

  std::vector<Density> MakeDensities(const std::vector<Cell>& cells) const;

  HipeEmissionSettings settings_;
  double shape_ = 0;
  double pooled_sd_db_ = 0;
  std::vector<double> log_silence_;              // of each point; 0 without use_silence
  std::vector<std::vector<Density>> densities_;  // of each transmitter of the site, by point
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_HIPE_EMISSION_H_
