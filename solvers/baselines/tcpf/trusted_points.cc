#include "solvers/baselines/tcpf/trusted_points.h"

namespace walkgraph {

std::vector<bool> TrustedAt(const EstimateResult& result, const std::vector<Waypoint>& waypoints) {
  Stream<double> trusted;
  for (const SlowStateEstimate& state : result.slow_states) {
    if (state.name == kTrustedState) trusted.push_back(state.time_ns, state.value);
  }
  std::vector<bool> at;
  if (trusted.empty()) return at;
  for (const Waypoint& waypoint : waypoints) {
    at.push_back(trusted.value[NearestTime(trusted.time_ns, waypoint.time_ns)] > 0.5);
  }
  return at;
}

}  // namespace walkgraph
