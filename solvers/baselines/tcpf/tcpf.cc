#include "solvers/baselines/tcpf/tcpf.h"

#include <limits>

#include "factors/dead_reckoning.h"
#include "solvers/baselines/fingerprints.h"
#include "solvers/baselines/tcpf/heading_filter.h"
#include "solvers/baselines/tcpf/trusted_points.h"

namespace walkgraph {
namespace {

std::vector<PositionFix> ToFixes(const std::vector<TcpfPosition>& positions, int floor) {
  std::vector<PositionFix> fixes;
  for (const TcpfPosition& position : positions) {
    PositionFix fix;
    fix.time_ns = position.time_ns;
    fix.position_m = position.position_m;
    fix.floor = floor;
    fixes.push_back(fix);
  }
  return fixes;
}

// Before the first and after the last scan dead reckoning goes on alone.
void ExtendByReckoning(const Evidence& evidence, const DeadReckonedPath& path,
                       std::vector<PositionFix>* fixes) {
  PositionFix first = fixes->front(), last = fixes->back();
  first.position_m += path.PositionAt(evidence.begin_ns) - path.PositionAt(first.time_ns);
  first.time_ns = evidence.begin_ns;
  last.position_m += path.PositionAt(evidence.end_ns) - path.PositionAt(last.time_ns);
  last.time_ns = evidence.end_ns;
  if (first.time_ns < fixes->front().time_ns) fixes->insert(fixes->begin(), first);
  if (last.time_ns > fixes->back().time_ns) fixes->push_back(last);
}

}  // namespace

std::string TcpfEstimator::Lack(const Evidence& evidence) const {
  if (evidence.motion.empty()) return "no accelerometer: neither motion state nor steps";
  if (IsWifiAlone()) return "";
  if (evidence.gyro_yaw_rad.empty()) return "no gyroscope for the heading filter";
  if (evidence.absolute_heading_rad.empty() || !factors_.absolute_heading.enabled) {
    return "no absolute heading: neither magnetometer nor rotation vector";
  }
  return "";
}

EstimateResult TcpfEstimator::Estimate(const Site& site, const Evidence& evidence) const {
  if (const std::string lack = Lack(evidence); !lack.empty()) {
    EstimateResult result;
    result.status = EstimateStatus::kUnsupported;
    result.messages.push_back(lack);
    return result;
  }
  if (IsWifiAlone()) return Locate(site, evidence);
  const Evidence filtered = WithFilteredHeading(evidence, settings_.heading);
  if (method_.variant == TcpfVariant::kDeadReckoning) {
    return DeadReckoningEstimator(pdr_, wknn_, factors_).Estimate(site, filtered);
  }
  return Locate(site, filtered);
}

std::vector<TcpfPosition> TcpfEstimator::Solve(const std::vector<TcpfEpoch>& epochs,
                                               const TcpfWifi& wifi) const {
  if (IsWifiAlone()) return LocateByWifi(epochs, wifi);
  if (method_.variant == TcpfVariant::kCrossAssistive) {
    return FuseByCrossAssistance(epochs, wifi, settings_);
  }
  return FuseByTrust(epochs, wifi, settings_);
}

EstimateResult TcpfEstimator::Locate(const Site& site, const Evidence& evidence) const {
  const DeadReckonedPath path = DeadReckon(site, evidence, factors_);
  const int floor = WalkFloor(site, evidence, wknn_);
  const TcpfWifi wifi(site, floor, settings_.wifi, wknn_,
                      method_.variant != TcpfVariant::kThreshold);
  std::vector<TcpfPosition> positions;
  if (!wifi.empty()) {
    positions = Solve(
        CollectEpochs(evidence, path, CollectQueryScans(site, evidence, wknn_.max_age_s)), wifi);
  }
  if (positions.empty()) {
    return UnlocatedResult(site, evidence, path, "no Wi-Fi signal over the threshold");
  }
  std::vector<PositionFix> fixes = ToFixes(positions, floor);
  EstimateResult result;
  if (!IsWifiAlone()) {
    ExtendByReckoning(evidence, path, &fixes);
    for (const TcpfPosition& position : positions) {
      result.slow_states.push_back({std::string(kTrustedState), position.time_ns,
                                    position.trusted ? 1.0 : 0.0,
                                    std::numeric_limits<double>::quiet_NaN()});
    }
  }
  result.trajectory = TrajectoryFromFixes(site, evidence, path, fixes);
  return result;
}

}  // namespace walkgraph
