#ifndef WALKGRAPH_DATA_SIMULATOR_PLAN_H_
#define WALKGRAPH_DATA_SIMULATOR_PLAN_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "data/building.h"

namespace walkgraph {

struct Wall {
  Eigen::Vector2d begin = Eigen::Vector2d::Zero();
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  int floor = 0;
};

enum class WayKind : std::uint8_t { kCorridor, kStairs, kLift, kEscalator };

// A bend of a way, in the building frame.
struct WayPoint {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  double height_m = 0;
};

// Where ways meet.
struct WayNode {
  int floor = 0;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
};

// A way between two nodes. A link of kind kLift joins the cabin's nodes on two floors.
struct WayLink {
  int from = 0;
  int to = 0;
  WayKind kind = WayKind::kCorridor;
  std::vector<WayPoint> bends;  // between the nodes, from the first to the second
};

// A building with what the simulator alone may know: the walls that radio waves go through and the
// middle lines of the ways.
struct Plan {
  Building building;
  std::vector<Wall> walls;  // each once, although two rooms may share it
  std::vector<WayNode> nodes;
  std::vector<WayLink> links;
  double scatter_m = 0;  // people pass nodes at up to this distance along each axis: open areas

  const WayNode& Node(int index) const { return nodes[static_cast<std::size_t>(index)]; }
  const WayLink& Link(int index) const { return links[static_cast<std::size_t>(index)]; }
  // Height of a floor; 0 where the building does not have it.
  double HeightOf(int floor) const;
  // The floor that lies nearest to a height.
  int FloorAt(double height_m) const;
  int AddNode(int floor, const Eigen::Vector2d& position_m);
  void AddLink(int from, int to, WayKind kind = WayKind::kCorridor,
               std::vector<WayPoint> bends = {});
};

// How many walls of a floor the straight line between two points goes through.
int CountWallsBetween(const Plan& plan, int floor, const Eigen::Vector2d& a,
                      const Eigen::Vector2d& b);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_PLAN_H_
