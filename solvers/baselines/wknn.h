#ifndef WALKGRAPH_SOLVERS_BASELINES_WKNN_H_
#define WALKGRAPH_SOLVERS_BASELINES_WKNN_H_

#include <string_view>
#include <vector>

#include "factors/settings.h"
#include "solvers/baselines/description.h"
#include "solvers/baselines/fingerprints.h"
#include "solvers/baselines/fixes.h"
#include "solvers/estimator.h"

namespace walkgraph {

// The fixed definition that every comparison refers to; changing it changes what "wknn" means.
struct WknnSettings {
  int k = 5;
  double missing_dbm = -100;
  double max_age_s = 3;
  bool refresh_weights = false;
};

template <typename Visitor>
void Visit(Visitor& v, WknnSettings& s) {
  v.Field("k", s.k, "nearest fingerprints that are averaged; `nn` always takes one");
  v.Field("missing_dbm", s.missing_dbm, "stands for an access point that a scan did not hear, dBm");
  v.Field("max_age_s", s.max_age_s, "readings older than this when printed are not used, s");
  v.Field("refresh_weights", s.refresh_weights,
          "access points count by TCPF's refresh rate at their signal, for every method that takes "
          "these neighbours");
}

// One scan's fix: the mean of its nearest fingerprints' positions, weights 1/d (a distance of zero
// takes all weight there is). The floor is that of most neighbours, of equal ones the nearest's,
// and the neighbours of other floors do not count. Precondition: neighbours is not empty.
PositionFix WknnFix(const Fingerprints& fingerprints, const std::vector<Neighbour>& neighbours);

// A fix per scan of the walk, in order of time.
std::vector<PositionFix> WknnFixes(const Site& site, const Evidence& evidence,
                                   const WknnSettings& settings);

// The floor that a walk's evidence says, else that of most of its WKNN fixes, else the one with the
// longest survey path.
int WalkFloor(const Site& site, const Evidence& evidence, const WknnSettings& settings);

inline constexpr MethodDescription kNearestNeighbourDescription{
    "nn", "position of the survey scan nearest in signal space, scan by scan",
    "Bahl and Padmanabhan, RADAR, INFOCOM 2000",
    "Wi-Fi only; access points that the survey never heard are left out; linear in time between "
    "scans, clamped at the ends; no covariance"};
inline constexpr MethodDescription kWknnDescription{
    "wknn", "mean of the 5 survey scans nearest in signal space, weights 1/d, scan by scan",
    "Bahl and Padmanabhan, RADAR, INFOCOM 2000; weights 1/d as commonly used",
    "Wi-Fi only; missing -100 dBm; readings under 3 s old; at the mean time heard; access points "
    "that the survey never heard are left out; linear in time, clamped at the ends; no covariance"};

// `wknn`, and with one neighbour `nn`.
class WknnEstimator : public Estimator {
 public:
  WknnEstimator(std::string_view name, const WknnSettings& settings, const FactorSettings& factors)
      : name_(name), settings_(settings), factors_(factors) {}
  static WknnEstimator NearestNeighbour(WknnSettings settings, const FactorSettings& factors) {
    settings.k = 1;
    return {kNearestNeighbourDescription.name, settings, factors};
  }
  static WknnEstimator Wknn(const WknnSettings& settings, const FactorSettings& factors) {
    return {kWknnDescription.name, settings, factors};
  }

  std::string_view name() const override { return name_; }
  EstimateResult Estimate(const Site& site, const Evidence& evidence) const override;

 private:
  std::string_view name_;  // of a description with static storage
  WknnSettings settings_;
  FactorSettings factors_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_WKNN_H_
