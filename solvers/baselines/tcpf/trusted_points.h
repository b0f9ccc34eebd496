#ifndef WALKGRAPH_SOLVERS_BASELINES_TCPF_TRUSTED_POINTS_H_
#define WALKGRAPH_SOLVERS_BASELINES_TCPF_TRUSTED_POINTS_H_

#include <string_view>
#include <vector>

#include "data/truth.h"
#include "solvers/estimator.h"

namespace walkgraph {

// The slow state by which a method marks the positions that it took for anchors: 1 there, 0 at its
// others.
inline constexpr std::string_view kTrustedState = "trusted";

// Whether the position nearest in time to each waypoint is such a one; empty for methods that mark
// none of their positions either way.
std::vector<bool> TrustedAt(const EstimateResult& result, const std::vector<Waypoint>& waypoints);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_TCPF_TRUSTED_POINTS_H_
