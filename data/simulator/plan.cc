#include "data/simulator/plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace walkgraph {
namespace {

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool Intersect(const Wall& wall, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d line = b - a;
  const Eigen::Vector2d along = wall.end - wall.begin;
  const bool wall_straddles = (Cross(line, wall.begin - a) > 0) != (Cross(line, wall.end - a) > 0);
  const bool line_straddles =
      (Cross(along, a - wall.begin) > 0) != (Cross(along, b - wall.begin) > 0);
  return wall_straddles && line_straddles;
}

}  // namespace

double Plan::HeightOf(int floor) const {
  const Floor* found = building.FindFloor(floor);
  return found == nullptr ? 0.0 : found->height_m;
}

int Plan::FloorAt(double height_m) const {
  const auto nearest = std::min_element(
      building.floors.begin(), building.floors.end(), [height_m](const Floor& a, const Floor& b) {
        return std::abs(a.height_m - height_m) < std::abs(b.height_m - height_m);
      });
  return nearest->number;
}

int Plan::AddNode(int floor, const Eigen::Vector2d& position_m) {
  nodes.push_back({floor, position_m});
  return static_cast<int>(nodes.size()) - 1;
}

void Plan::AddLink(int from, int to, WayKind kind, std::vector<WayPoint> bends) {
  links.push_back({from, to, kind, std::move(bends)});
}

int CountWallsBetween(const Plan& plan, int floor, const Eigen::Vector2d& a,
                      const Eigen::Vector2d& b) {
  return static_cast<int>(std::count_if(
      plan.walls.begin(), plan.walls.end(),
      [&](const Wall& wall) { return wall.floor == floor && Intersect(wall, a, b); }));
}

}  // namespace walkgraph
