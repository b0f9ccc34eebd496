#include "solvers/baselines/ahf/ahf.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>

#include "factors/dead_reckoning.h"
#include "solvers/baselines/ahf/dynamic_weights.h"
#include "solvers/baselines/fingerprints.h"

namespace walkgraph {

std::vector<RatedFix> RateFixes(const Site& site, const Evidence& evidence, int floor,
                                const AhfSettings& settings, const WknnSettings& wknn) {
  const Fingerprints fingerprints(site, floor, wknn.max_age_s, wknn.missing_dbm);
  std::vector<RatedFix> fixes;
  if (fingerprints.size() == 0) return fixes;
  const auto neighbour_count = static_cast<std::size_t>(std::max(1, wknn.k));
  const auto candidate_count = static_cast<std::size_t>(std::max(1, settings.candidates));
  for (const QueryScan& scan : CollectQueryScans(site, evidence, wknn.max_age_s)) {
    std::vector<Neighbour> nearest = fingerprints.Nearest(
        scan.signal, std::max(neighbour_count, candidate_count), {wknn.refresh_weights, {}});
    std::vector<Eigen::Vector2d> candidates_m;
    for (std::size_t i = 0; i < std::min(candidate_count, nearest.size()); ++i) {
      candidates_m.push_back(fingerprints.position_m(nearest[i].fingerprint));
    }
    nearest.resize(std::min(neighbour_count, nearest.size()));
    RatedFix rated{WknnFix(fingerprints, nearest),
                   BestCandidateSetError(candidates_m, settings.fingerprint_spacing_m)};
    rated.fix.time_ns = scan.time_ns;
    fixes.push_back(rated);
  }
  return fixes;
}

std::unique_ptr<PositionFilter> AhfEstimator::MakeFilter(const WayGraph& ways) const {
  if (method_.particles > 0) {
    return MakeParticleFilter(method_.particles, method_.weights, settings_);
  }
  return MakeAhfFilter(method_.prediction, method_.weights, &ways, settings_);
}

EstimateResult AhfEstimator::Estimate(const Site& site, const Evidence& evidence) const {
  const DeadReckonedPath path = DeadReckon(site, evidence, factors_);
  const int floor = WalkFloor(site, evidence, wknn_);
  EstimateResult result;
  const WayGraph ways(FindWays(site, floor, settings_.merge_m, settings_.straight_rad));
  if (method_.prediction == AhfPrediction::kWays && ways.empty()) {
    result.status = EstimateStatus::kUnsupported;
    result.messages.push_back("no way network: floor " + std::to_string(floor) +
                              " has neither ways nor survey walks");
    return result;
  }
  const std::vector<RatedFix> rated_fixes = RateFixes(site, evidence, floor, settings_, wknn_);
  if (rated_fixes.empty()) {
    return UnlocatedResult(site, evidence, path, "no Wi-Fi scan that the survey knows");
  }
  const std::unique_ptr<PositionFilter> filter = MakeFilter(ways);
  std::vector<PositionFix> fixes;
  for (const RatedFix& rated : rated_fixes) {
    const double seconds =
        fixes.empty() ? 0.0 : SecondsBetween(fixes.back().time_ns, rated.fix.time_ns);
    fixes.push_back(filter->Advance(rated, seconds));
    result.slow_states.push_back({"bcs_error_m", rated.fix.time_ns, rated.error_m,
                                  std::numeric_limits<double>::quiet_NaN()});
  }
  result.trajectory = TrajectoryFromFixes(site, evidence, path, fixes);
  return result;
}

}  // namespace walkgraph
