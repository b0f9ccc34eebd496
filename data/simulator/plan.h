#ifndef WALKGRAPH_DATA_SIMULATOR_PLAN_H_
#define WALKGRAPH_DATA_SIMULATOR_PLAN_H_

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "data/building.h"

namespace walkgraph {

struct Wall {
  Eigen::Vector2d begin = Eigen::Vector2d::Zero();
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
};

// A building with what the simulator alone may know: the walls that radio waves go through and the
// middle lines of the corridors.
struct Plan {
  Building building;
  std::vector<Wall> walls;                 // each once, although two rooms may share it
  std::vector<Eigen::Vector2d> nodes;      // where corridors meet
  std::vector<std::pair<int, int>> links;  // straight corridors between nodes
};

// One floor of offices, 44 m by 24 m: two corridors along x, joined by three along y, rooms around
// and between them.
Plan MakeOfficePlan();

// How many walls the straight line between two points goes through.
int CountWallsBetween(const Plan& plan, const Eigen::Vector2d& a, const Eigen::Vector2d& b);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_PLAN_H_
