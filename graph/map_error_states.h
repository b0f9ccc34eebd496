#ifndef WALKGRAPH_GRAPH_MAP_ERROR_STATES_H_
#define WALKGRAPH_GRAPH_MAP_ERROR_STATES_H_

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "factors/settings.h"
#include "factors/state_blocks.h"
#include "graph/slow_states.h"
#include "graph/walk_graph.h"

namespace walkgraph {

// Adds the error of a map (kMapError or kMagneticError) of stationary sigma `sigma_m` to the graph
// of a walk whose nodes are there; absent where sigma_m is 0. Each knot is conditioned on the one
// before, as far from it as was walked between them: what is known before anybody knows where.
KnotBlocks AddMapErrorState(BlockKind kind, const MapErrorSettings& settings, double sigma_m,
                            const std::vector<const RadioMap*>& widened_by, WalkGraph* walk);

// The same, with each knot conditioned on those before that tell most of it by where the graph's
// values have them: who comes back to a place finds the map's error there again. Errors on
// different floors are independent, as their maps are.
void ConditionOnPlaces(WalkGraph* walk);

// The same for the knots of a walk under way: those that `is_new` names among the graph's blocks
// are conditioned on those that `is_known` names, by the nodes until `now_ns`.
void ConditionNewOnPlaces(TimeNs now_ns, const std::function<bool(int)>& is_new,
                          const std::function<bool(int)>& is_known, WalkGraph* walk);

// What every knot of every map's error is conditioned on.
using MapErrorConditionals = std::vector<std::vector<SparseConditional>>;
MapErrorConditionals Conditionals(const WalkGraph& walk);
// As before anybody knew where the walk went.
MapErrorConditionals ConditionalsAsWalked(const WalkGraph& walk);
// Takes the walk's graph (back) to these. Those that it has already cost nothing.
void SetConditionals(const MapErrorConditionals& conditionals, WalkGraph* walk);

// Where the walk was while a knot of a map's error held: the middle of its nodes.
struct KnotPlace {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  int floor = 0;
};

// By the graph's values, of the knots that began until `now_ns`, each by its nodes until then.
std::vector<KnotPlace> KnotPlaces(const MapErrorKnots& knots, const WalkGraph& walk, TimeNs now_ns);

// By how much the maps' error is larger at the place of each knot than its kernel says: 1 on the
// survey (see ErrorRatio), of several maps the worst. Of the knots that began until `now_ns`.
std::vector<double> WideningOfKnots(const MapErrorKnots& knots, const WalkGraph& walk,
                                    TimeNs now_ns);

// Variable `index` given at most `most` of those before it, chosen one after the other by how much
// of the variance they take (Vecchia's approximation with the neighbours that matter). Stops where
// the next would take under a hundredth of what is left.
SparseConditional ConditionOnEarlier(int index, const std::function<double(int, int)>& correlation,
                                     int most);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_MAP_ERROR_STATES_H_
