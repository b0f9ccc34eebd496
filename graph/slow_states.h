#ifndef WALKGRAPH_GRAPH_SLOW_STATES_H_
#define WALKGRAPH_GRAPH_SLOW_STATES_H_

#include <vector>

#include "data/time.h"
#include "factors/rssi_offset.h"
#include "factors/settings.h"
#include "factors/state_blocks.h"
#include "graph/factor_graph.h"

namespace walkgraph {

// The blocks of a slow state in a graph.
struct KnotBlocks {
  Knots knots;
  std::vector<int> blocks;
  int At(TimeNs time_ns) const { return blocks[static_cast<std::size_t>(knots.At(time_ns))]; }
};

// How a scalar slow state starts and drifts. Held states (fixed or absent) are one constant block:
// every factor sees the same arguments whatever is switched off.
struct RandomWalkModel {
  BlockKind kind = BlockKind::kGyroBias;
  StateMode mode = StateMode::kActive;
  double absent_value = 0;  // what the model is without the state
  double prior_mean = 0;
  double prior_sigma = 1;
  double rate_per_sqrt_s = 1;
  double knot_s = 1;
};
KnotBlocks AddRandomWalkState(const RandomWalkModel& model, TimeNs begin_ns, TimeNs end_ns,
                              FactorGraph* graph);

// The offset of a radio, which stays the same all walk long; held where its prior has no spread.
int AddRssiOffsetState(const RssiOffsetPrior& prior, Radio radio, TimeNs begin_ns,
                       FactorGraph* graph);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_SLOW_STATES_H_
