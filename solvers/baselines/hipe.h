#ifndef WALKGRAPH_SOLVERS_BASELINES_HIPE_H_
#define WALKGRAPH_SOLVERS_BASELINES_HIPE_H_

#include <cstdint>
#include <string_view>

#include "factors/settings.h"
#include "solvers/baselines/description.h"
#include "solvers/baselines/hipe_emission.h"
#include "solvers/baselines/hipe_motion.h"
#include "solvers/baselines/reference_points.h"
#include "solvers/baselines/wknn.h"
#include "solvers/estimator.h"

namespace walkgraph {

struct HipeSettings {
  ReferencePointSettings points;
  HipeEmissionSettings emission;
  HipeMotionSettings motion;
  double k_min = 200;
  double k_max = 200'000;
};

template <typename Visitor>
void Visit(Visitor& v, HipeSettings& s) {
  Visit(v, s.points);
  Visit(v, s.emission);
  Visit(v, s.motion);
  v.Field("k_min", s.k_min, "ratio of high to low transition probabilities at least");
  v.Field("k_max", s.k_max, "and at most: standing, or sure of the last estimate and the motion");
}

// The ratio K for the next transition, from k_min to k_max on a logarithmic scale by the confidence
// `estimate` * `motion`, both in [0, 1].
double AdaptiveK(double estimate, double motion, const HipeSettings& settings);

inline constexpr std::string_view kHipeSource =
    "Liu, Chen, Pei, Guinness and Kuusniemi, Sensors 12 (2012) 17208-17233";
inline constexpr std::string_view kHipeOwnChoices =
    "epochs: Wi-Fi scans at the mean time heard. Reference points: within 3 m of a survey path. "
    "Weibull tables: moments of the survey readings within 3 m of a point, variance drawn towards "
    "the floor's pooled one and widened for the uncertain mean, one shape from the pooled "
    "skewness. "
    "Beyond the paper, both switches: unheard access points count by how often they are heard near "
    "a point (use_silence); a scan weighs min(1, N_eff / N) (use_effective_readings). Steps count "
    "by "
    "the share of each between two epochs; the heading is that of their sum, corrected by the "
    "calibrated mean offset. K = k_min (k_max / k_min)^c with c = posterior mass within one point "
    "of the last estimate x share of time the phone is not handled x probability that the heading "
    "is within its tolerance; standing: k_max. Between epochs linear in time; covariance of the "
    "filter: of its posterior about the chosen point";
inline constexpr MethodDescription kHipeFilterDescription{
    "hipe_filter",
    "grid filter on reference points 3 m apart, steps and compass as ring and sector", kHipeSource,
    kHipeOwnChoices};
inline constexpr MethodDescription kHipeViterbiDescription{
    "hipe_viterbi", "the most likely sequence of HIPE's reference points", kHipeSource,
    kHipeOwnChoices};

enum class HipeSolver : std::uint8_t { kFilter, kViterbi };

// `hipe_filter` and `hipe_viterbi`: HIPE, complete, with Wi-Fi scans as epochs.
class HipeEstimator : public Estimator {
 public:
  HipeEstimator(HipeSolver solver, const HipeSettings& settings, const WknnSettings& wknn,
                const FactorSettings& factors)
      : solver_(solver), settings_(settings), wknn_(wknn), factors_(factors) {}
  std::string_view name() const override {
    return solver_ == HipeSolver::kFilter ? kHipeFilterDescription.name
                                          : kHipeViterbiDescription.name;
  }
  EstimateResult Estimate(const Site& site, const Evidence& evidence) const override;

 private:
  class Run;

  HipeSolver solver_;
  HipeSettings settings_;
  WknnSettings wknn_;
  FactorSettings factors_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_HIPE_H_
