#ifndef WALKGRAPH_SOLVERS_BASELINES_DEAD_RECKONING_H_
#define WALKGRAPH_SOLVERS_BASELINES_DEAD_RECKONING_H_

#include <Eigen/Core>
#include <string_view>
#include <vector>

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

// Displacement since the first step: each step goes its length times `step_scale` in the walking
// direction at its middle, at constant speed between its begin and end.
class StepPath {
 public:
  // `heading_rad` is the walking direction in the building frame at the middle of each step.
  StepPath(const std::vector<StepEvidence>& steps, const std::vector<double>& heading_rad,
           double step_scale);
  Eigen::Vector2d At(TimeNs time_ns) const;

 private:
  const std::vector<StepEvidence>& steps_;
  std::vector<Eigen::Vector2d> before_;  // displacement at each step's begin, and at the end
};

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
  std::vector<PositionFix> Starts(const Site& site, const Evidence& evidence, const StepPath& path,
                                  EstimateResult* result) const;

  DeadReckoningSettings settings_;
  WknnSettings wknn_;
  FactorSettings factors_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_DEAD_RECKONING_H_
