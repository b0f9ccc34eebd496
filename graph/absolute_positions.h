#ifndef WALKGRAPH_GRAPH_ABSOLUTE_POSITIONS_H_
#define WALKGRAPH_GRAPH_ABSOLUTE_POSITIONS_H_

#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"
#include "graph/walk_graph.h"

namespace walkgraph {

// Adds what says where a walk is, to a graph that has its nodes: the scans of every radio with a
// map of the floor, with the states that stand between map and walk, and anchors on the floor.
void AddAbsolutePositions(const Site& site, const Evidence& evidence,
                          const FactorSettings& settings, WalkGraph* walk);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_ABSOLUTE_POSITIONS_H_
