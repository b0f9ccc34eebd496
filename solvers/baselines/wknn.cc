#include "solvers/baselines/wknn.h"

#include <algorithm>
#include <cstddef>
#include <map>

#include "factors/dead_reckoning.h"

namespace walkgraph {
namespace {

// The value that occurs most; of equally frequent ones that which comes first. Not for nothing.
int Majority(const std::vector<int>& values) {
  std::map<int, int> counts;
  for (const int value : values) ++counts[value];
  int best = values.front();
  for (const int value : values) {
    if (counts[value] > counts[best]) best = value;
  }
  return best;
}

}  // namespace

PositionFix WknnFix(const Fingerprints& fingerprints, const std::vector<Neighbour>& neighbours) {
  // Under this distance a fingerprint is the scan itself: its 1/d outweighs any other by far.
  constexpr double kSmallestDistanceDb = 1e-6;
  std::vector<int> floors;
  for (const Neighbour& neighbour : neighbours) {
    floors.push_back(fingerprints.floor(neighbour.fingerprint));
  }
  PositionFix fix;
  fix.floor = Majority(floors);
  double weight_sum = 0;
  for (const Neighbour& neighbour : neighbours) {
    if (fingerprints.floor(neighbour.fingerprint) != fix.floor) continue;
    const double weight = 1 / std::max(kSmallestDistanceDb, neighbour.distance_db);
    fix.position_m += weight * fingerprints.position_m(neighbour.fingerprint);
    weight_sum += weight;
  }
  fix.position_m /= weight_sum;
  return fix;
}

std::vector<PositionFix> WknnFixes(const Site& site, const Evidence& evidence,
                                   const WknnSettings& settings) {
  const Fingerprints fingerprints(site, evidence.floor, settings.max_age_s, settings.missing_dbm);
  std::vector<PositionFix> fixes;
  if (fingerprints.size() == 0) return fixes;
  for (const QueryScan& scan : CollectQueryScans(site, evidence, settings.max_age_s)) {
    const auto k = static_cast<std::size_t>(std::max(1, settings.k));
    fixes.push_back(WknnFix(fingerprints,
                            fingerprints.Nearest(scan.signal, k, {settings.refresh_weights, {}})));
    fixes.back().time_ns = scan.time_ns;
  }
  return fixes;
}

int WalkFloor(const Site& site, const Evidence& evidence, const WknnSettings& settings) {
  if (evidence.floor) return *evidence.floor;
  std::vector<int> floors;
  for (const PositionFix& fix : WknnFixes(site, evidence, settings)) floors.push_back(fix.floor);
  return floors.empty() ? SurveyCentroid(site, {}).floor : Majority(floors);
}

EstimateResult WknnEstimator::Estimate(const Site& site, const Evidence& evidence) const {
  const DeadReckonedPath path = DeadReckon(site, evidence, factors_);
  const std::vector<PositionFix> fixes = WknnFixes(site, evidence, settings_);
  if (fixes.empty()) {
    return UnlocatedResult(site, evidence, path, "no Wi-Fi scan that the survey knows");
  }
  EstimateResult result;
  result.trajectory = TrajectoryFromFixes(site, evidence, path, fixes);
  return result;
}

}  // namespace walkgraph
