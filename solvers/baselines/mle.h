#ifndef WALKGRAPH_SOLVERS_BASELINES_MLE_H_
#define WALKGRAPH_SOLVERS_BASELINES_MLE_H_

#include <string_view>

#include "factors/settings.h"
#include "solvers/baselines/description.h"
#include "solvers/baselines/reference_points.h"
#include "solvers/baselines/wknn.h"
#include "solvers/estimator.h"

namespace walkgraph {

struct MleSettings {
  ReferencePointSettings points{ReferenceArea::kSurveyed, 1.0, 3.0};
};

template <typename Visitor>
void Visit(Visitor& v, MleSettings& s) {
  Visit(v, s.points);
}

inline constexpr MethodDescription kMleDescription{
    "mle", "the reference point where the radio map makes a scan most likely, scan by scan",
    "maximum likelihood as the comparison in Liu et al., Sensors 12 (2012), with the radio map and "
    "likelihood of the graph (silence of unheard transmitters included) in place of Weibull tables",
    "points 1 m apart within 3 m of a survey path; beacons join the Wi-Fi scan nearest in time; "
    "linear in time between scans; covariance: of the likelihood as a posterior about the chosen "
    "point, plus the map error's and the lattice cell's"};

// `mle`.
class MleEstimator : public Estimator {
 public:
  MleEstimator(const MleSettings& settings, const WknnSettings& wknn, const FactorSettings& factors)
      : settings_(settings), wknn_(wknn), factors_(factors) {}
  std::string_view name() const override { return kMleDescription.name; }
  EstimateResult Estimate(const Site& site, const Evidence& evidence) const override;

 private:
  MleSettings settings_;
  WknnSettings wknn_;
  FactorSettings factors_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_MLE_H_
