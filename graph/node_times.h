#ifndef WALKGRAPH_GRAPH_NODE_TIMES_H_
#define WALKGRAPH_GRAPH_NODE_TIMES_H_

#include <vector>

#include "data/time.h"
#include "frontends/evidence/evidence.h"

namespace walkgraph {

// Nodes closer than this are one: what happens between them is split by time, so that nothing is
// lost, and no factor divides by next to nothing.
inline constexpr TimeNs kMinNodeGapNs = 20 * kNsPerMs;
inline constexpr TimeNs kMaxNodeGapNs = kNsPerSecond;

// Times of the nodes of a walk, strictly increasing and never empty: both ends of the recorded
// span, every step's begin and end, and in between so many that no gap exceeds a second.
std::vector<TimeNs> GraphNodeTimes(const Evidence& evidence);

// Where a time falls among nodes: state = (1 - fraction) node[before] + fraction node[before + 1].
// Clamped at the ends; fraction 0 needs node `before` alone.
struct NodeBracket {
  int before = 0;
  double fraction = 0;
};
// Precondition: `nodes_ns` is not empty and increases.
NodeBracket FindBracket(const std::vector<TimeNs>& nodes_ns, TimeNs time_ns);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_NODE_TIMES_H_
