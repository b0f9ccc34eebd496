#include "solvers/baselines/tcpf/fusion.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace walkgraph {
namespace {

using Eigen::Vector2d;

bool IsStanding(const Evidence& evidence, TimeNs time_ns) {
  return std::any_of(evidence.motion.begin(), evidence.motion.end(),
                     [time_ns](const MotionInterval& interval) {
                       return interval.state == MotionState::kStanding &&
                              interval.begin_ns <= time_ns && time_ns < interval.end_ns;
                     });
}

// Distance along the dead-reckoned path since its beginning.
Stream<double> WalkedDistance(const DeadReckonedPath& path) {
  Stream<double> walked;
  double distance_m = 0;
  for (std::size_t i = 0; i < path.position_m.time_ns.size(); ++i) {
    if (i > 0) distance_m += (path.position_m.value[i] - path.position_m.value[i - 1]).norm();
    walked.push_back(path.position_m.time_ns[i], distance_m);
  }
  return walked;
}

// Where dead reckoning leads from the last position, and the area about it.
TrustedArea AreaFrom(const TcpfPosition& last, const Vector2d& displacement_m,
                     const TcpfSettings& settings) {
  return {last.position_m, displacement_m, settings.distance_tolerance_m,
          settings.direction_tolerance_rad};
}

WifiCandidates Within(const TrustedArea& area, WifiCandidates candidates) {
  std::erase_if(candidates.nearest, [&](const Neighbour& neighbour) {
    return !area.Contains(candidates.PositionOf(neighbour));
  });
  return candidates;
}

// The first epoch at which Wi-Fi says anything; the number of epochs where it never does.
std::size_t FindStart(const std::vector<TcpfEpoch>& epochs, const TcpfWifi& wifi,
                      std::vector<TcpfPosition>* positions) {
  std::size_t k = 0;
  for (; k < epochs.size(); ++k) {
    const WifiCandidates candidates = wifi.Find(epochs[k].scan.signal, epochs[k].moving);
    if (candidates.empty()) continue;
    positions->push_back({epochs[k].scan.time_ns, candidates.Mean(), false});
    break;
  }
  return k;
}

}  // namespace

std::vector<TcpfEpoch> CollectEpochs(const Evidence& evidence, const DeadReckonedPath& path,
                                     std::vector<QueryScan> scans) {
  const Stream<double> walked_m = WalkedDistance(path);
  std::vector<TcpfEpoch> epochs;
  for (QueryScan& scan : scans) {
    const TimeNs time = scan.time_ns;
    epochs.push_back({std::move(scan), !IsStanding(evidence, time), path.PositionAt(time),
                      Interpolate(walked_m, time)});
  }
  return epochs;
}

std::vector<TcpfPosition> LocateByWifi(const std::vector<TcpfEpoch>& epochs, const TcpfWifi& wifi) {
  std::vector<TcpfPosition> positions;
  for (const TcpfEpoch& epoch : epochs) {
    const WifiCandidates candidates = wifi.Find(epoch.scan.signal, epoch.moving);
    if (!candidates.empty()) positions.push_back({epoch.scan.time_ns, candidates.Mean(), false});
  }
  return positions;
}

std::vector<TcpfPosition> FuseByTrust(const std::vector<TcpfEpoch>& epochs, const TcpfWifi& wifi,
                                      const TcpfSettings& settings) {
  std::vector<TcpfPosition> positions;
  std::size_t last = FindStart(epochs, wifi, &positions);
  TrustChain chain(settings.pdr_error_per_m / settings.wifi_error_m, settings.unlock_at,
                   TrustState::kUnlocked, settings.unlock_at);
  for (std::size_t k = last + 1; k < epochs.size(); ++k) {
    const WifiCandidates all = wifi.Find(epochs[k].scan.signal, epochs[k].moving);
    if (all.empty()) continue;
    const Vector2d displacement_m = epochs[k].reckoned_m - epochs[last].reckoned_m;
    const TrustedArea area = AreaFrom(positions.back(), displacement_m, settings);
    chain.Move(epochs[k].walked_m - epochs[last].walked_m);

    const bool trusted = area.Contains(all.Mean());
    const bool locked = trusted || chain.state() != TrustState::kUnlocked;
    const WifiCandidates used = locked ? Within(area, all) : all;
    Vector2d position_m = positions.back().position_m + displacement_m;
    if (!used.empty()) position_m = chain.Fuse(position_m, used.Mean());
    chain.Settle(trusted);
    positions.push_back({epochs[k].scan.time_ns, position_m, trusted});
    last = k;
  }
  return positions;
}

std::vector<TcpfPosition> FuseByCrossAssistance(const std::vector<TcpfEpoch>& epochs,
                                                const TcpfWifi& wifi,
                                                const TcpfSettings& settings) {
  std::vector<TcpfPosition> positions;
  std::size_t accepted = FindStart(epochs, wifi, &positions);
  if (positions.empty()) return positions;
  TcpfPosition anchor = positions.back();
  for (std::size_t k = accepted + 1; k < epochs.size(); ++k) {
    const Vector2d displacement_m = epochs[k].reckoned_m - epochs[accepted].reckoned_m;
    const TrustedArea area = AreaFrom(anchor, displacement_m, settings);
    const WifiCandidates candidates =
        wifi.Find(epochs[k].scan.signal, epochs[k].moving,
                  [&area](const Vector2d& point_m) { return area.Contains(point_m); });
    TcpfPosition position{epochs[k].scan.time_ns, anchor.position_m + displacement_m, false};
    if (!candidates.empty() && area.Contains(candidates.Mean())) {
      position.position_m = candidates.Mean();
      position.trusted = true;
      anchor = position;
      accepted = k;
    }
    positions.push_back(position);
  }
  return positions;
}

}  // namespace walkgraph
