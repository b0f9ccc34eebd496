#include "graph/node_times.h"

#include <algorithm>
#include <cstddef>

namespace walkgraph {
namespace {

// Wanted times to node times: too close ones dropped in favour of the earlier, but the last
// kept. A walk shorter than the smallest gap is one node.
std::vector<TimeNs> DropClose(const std::vector<TimeNs>& wanted) {
  std::vector<TimeNs> kept = {wanted.front()};
  for (const TimeNs time : wanted) {
    if (time - kept.back() >= kMinNodeGapNs) kept.push_back(time);
  }
  if (kept.size() == 1 || kept.back() == wanted.back()) return kept;
  kept.pop_back();
  kept.push_back(wanted.back());
  return kept;
}

}  // namespace

std::vector<TimeNs> GraphNodeTimes(const Evidence& evidence) {
  std::vector<TimeNs> wanted = {evidence.begin_ns, std::max(evidence.begin_ns, evidence.end_ns)};
  for (const StepEvidence& step : evidence.steps) {
    wanted.push_back(step.begin_ns);
    wanted.push_back(step.end_ns);
  }
  std::sort(wanted.begin(), wanted.end());
  const std::vector<TimeNs> kept = DropClose(wanted);
  std::vector<TimeNs> nodes = {kept.front()};
  for (std::size_t i = 1; i < kept.size(); ++i) {
    const TimeNs gap = kept[i] - kept[i - 1];
    const TimeNs parts = (gap + kMaxNodeGapNs - 1) / kMaxNodeGapNs;
    for (TimeNs part = 1; part <= parts; ++part) nodes.push_back(kept[i - 1] + gap * part / parts);
  }
  return nodes;
}

NodeBracket FindBracket(const std::vector<TimeNs>& nodes_ns, TimeNs time_ns) {
  const auto after = std::upper_bound(nodes_ns.begin(), nodes_ns.end(), time_ns);
  if (after == nodes_ns.begin()) return {0, 0.0};
  const int before = static_cast<int>(after - nodes_ns.begin()) - 1;
  if (after == nodes_ns.end()) return {before, 0.0};
  return {before, SecondsBetween(nodes_ns[before], time_ns) /
                      SecondsBetween(nodes_ns[before], nodes_ns[before + 1])};
}

}  // namespace walkgraph
