#ifndef WALKGRAPH_GRAPH_WALK_GRAPH_H_
#define WALKGRAPH_GRAPH_WALK_GRAPH_H_

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "data/trajectory.h"
#include "factors/floor_path.h"
#include "factors/map_error.h"
#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"
#include "graph/factor_graph.h"
#include "graph/slow_states.h"

namespace walkgraph {

// Type of the factor that stands for ignorance of where the walk begins.
inline constexpr std::string_view kPositionPriorType = "position_prior";

// A standardised Gaussian variable given others: x = weights^T x_given + N(0, variance).
struct SparseConditional {
  std::vector<int> given;
  Eigen::VectorXd weights;
  double variance = 1;
};

// The error of one map in a walk's graph.
struct MapErrorKnots {
  KnotBlocks state;
  std::vector<int> factors;  // of each knot given others
  MapErrorKernel kernel;
  std::vector<SparseConditional> as_walked;     // what each knot was first conditioned on
  std::vector<SparseConditional> conditionals;  // what it is now, as its factor says
  // The maps whose errors covariances take to be larger where they extrapolate.
  std::vector<const RadioMap*> widened_by;
};

// The factor graph of one walk whose floors are known: every node, slow state and factor that the
// evidence calls for. It does not depend on where the walk is thought to be, so that one graph
// serves all initial trajectories, and a window plays the same graph in order of time.
struct WalkGraph {
  FloorPath floors = 0;
  FactorGraph graph;
  std::vector<TimeNs> node_ns;
  std::vector<int> position;  // block of each node
  std::vector<int> heading;   // block of each node
  // Block of each node; empty where the walk stays on one level and no barometer ran.
  std::vector<int> height;
  std::vector<double> level_m;            // of each node: height of its floor, the building's
  Stream<double> walked_m;                // until each node, by the steps alone
  std::vector<MapErrorKnots> map_errors;  // of the maps that are known to err
  // When the first evidence of a place arrived (a scan that the map knows, an anchor); none: never.
  std::optional<TimeNs> first_absolute_position_ns;
  bool has_absolute_heading = false;
  Eigen::VectorXd prior_values;  // nodes at the middle of the floor, slow states at their means
};

// Throws std::invalid_argument where a setting is out of range (a sigma, spacing or time constant
// that is not positive). The site must outlive the graph.
WalkGraph BuildWalkGraph(const Site& site, const Evidence& evidence, const FactorSettings& settings,
                         const FloorPath& floors);

// The blocks of a node: position, heading, and height where there is one.
std::vector<int> NodeBlocks(const WalkGraph& walk, std::size_t node);

// Sets nodes to a trajectory, linear between its poses and clamped at its ends (at the middle of
// the floor if it is empty), and slow states to their prior means.
void SetTrajectory(const Trajectory& trajectory, WalkGraph* walk);

// Height of a floor above the building's datum; 0 where the building does not know it.
double HeightOfFloor(const Site& site, int floor);

// Middle of a floor's survey path, else of its bounding box, else the origin.
Eigen::Vector2d FloorCentre(const Site& site, int floor);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_WALK_GRAPH_H_
