#ifndef WALKGRAPH_SOLVERS_BASELINES_SWEEP_COSTS_H_
#define WALKGRAPH_SOLVERS_BASELINES_SWEEP_COSTS_H_

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "factors/map_sweeps.h"
#include "factors/rssi_offset.h"
#include "factors/settings.h"
#include "frontends/radio_map/radio_map.h"

namespace walkgraph {

// Of each sweep -log p (nats) at each position.
using SweepCosts = std::vector<std::shared_ptr<const std::vector<float>>>;

// What a LikelihoodGrid of the same arguments has for the sweeps. A thread keeps its last ones,
// some megabytes of them: the configurations of a study ask for the same walk on the same map one
// after the other, and a window for what it saw lately again and again. They are recognised by
// hashes of all contents that matter (128 bits); the answer is the same as if each were made anew.
SweepCosts EvaluateSweeps(const RadioMap& map, std::span<const Eigen::Vector2d> positions_m,
                          const RssiOffsetPrior& offset, const LossSettings& loss,
                          std::span<const MapSweep> sweeps);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_SWEEP_COSTS_H_
