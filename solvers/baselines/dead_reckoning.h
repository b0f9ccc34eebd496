#ifndef WALKGRAPH_SOLVERS_BASELINES_DEAD_RECKONING_H_
#define WALKGRAPH_SOLVERS_BASELINES_DEAD_RECKONING_H_

#include <string_view>
#include <vector>

#include "factors/dead_reckoning.h"
#include "factors/settings.h"
#include "solvers/baselines/description.h"
#include "solvers/baselines/fixes.h"
#include "solvers/baselines/wknn.h"
#include "solvers/estimator.h"

namespace walkgraph {

struct DeadReckoningSettings {
  int start_scans = 3;
};

template <typename Visitor>
void Visit(Visitor& v, DeadReckoningSettings& s) {
  v.Field("start_scans", s.start_scans,
          "first WKNN fixes, each taken back along the steps, whose mean is the start");
}

inline constexpr MethodDescription kDeadReckoningDescription{
    "pdr", "steps in the walking direction from a start, no correction on the way",
    "Jimenez et al., pedestrian dead reckoning, WISP 2009 (step and heading system)",
    "starts at the mean of the first 3 WKNN fixes taken back along the steps; where anchors are "
    "given, at each anchor anew instead; absolute heading plus the calibrated mean offset, without "
    "it the gyroscope alone; calibrated mean step scale; no covariance"};

// `pdr`. Unobservable where nothing fixes the start (then from the centroid of the survey) or the
// heading (then from that of the building's x axis).
class DeadReckoningEstimator : public Estimator {
 public:
  DeadReckoningEstimator(const DeadReckoningSettings& settings, const WknnSettings& wknn,
                         const FactorSettings& factors)
      : settings_(settings), wknn_(wknn), factors_(factors) {}
  std::string_view name() const override { return kDeadReckoningDescription.name; }
  EstimateResult Estimate(const Site& site, const Evidence& evidence) const override;

 private:
  // Where the path is known to pass, in order of time; one of them at least.
  std::vector<PositionFix> Starts(const Site& site, const Evidence& evidence,
                                  const DeadReckonedPath& path, EstimateResult* result) const;

  DeadReckoningSettings settings_;
  WknnSettings wknn_;
  FactorSettings factors_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_DEAD_RECKONING_H_
