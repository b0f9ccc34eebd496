#ifndef WALKGRAPH_GRAPH_MOTION_MODEL_H_
#define WALKGRAPH_GRAPH_MOTION_MODEL_H_

#include <vector>

#include "data/time.h"
#include "factors/settings.h"
#include "frontends/evidence/evidence.h"

namespace walkgraph {

// How far a person came along their heading between two nodes, before any step-scale state.
struct NodeMotion {
  double length_m = 0;
  double sigma_along_m = 0;
  double sigma_across_m = 0;
  bool stepped = false;  // false: no step lies here, both sigmas are equal
};

// The motion between each pair of neighbouring nodes (one entry fewer than nodes). A step that
// spans several intervals is split by time, its variance too. Time without a step adds variance:
// that of a standing person (sigma_mps^2 dt) where the evidence says standing or handling, that of
// an unseen walk ((unseen_mps dt)^2) elsewhere, and wherever steps are switched off.
std::vector<NodeMotion> MotionBetweenNodes(const std::vector<TimeNs>& nodes_ns,
                                           const Evidence& evidence,
                                           const FactorSettings& settings);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_MOTION_MODEL_H_
