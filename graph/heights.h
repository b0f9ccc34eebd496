#ifndef WALKGRAPH_GRAPH_HEIGHTS_H_
#define WALKGRAPH_GRAPH_HEIGHTS_H_

#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "graph/walk_graph.h"

namespace walkgraph {

// Adds the third dimension to a walk's nodes where something speaks of it: a barometer that takes
// part, or floors that change. Every node gets a height, held to the level's while the walk is on
// one, free between levels but for how fast people climb; the barometer ties heights to its offset.
void AddHeights(const Evidence& evidence, const FactorSettings& settings, WalkGraph* walk);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_HEIGHTS_H_
