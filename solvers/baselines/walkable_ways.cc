#include "solvers/baselines/walkable_ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "solvers/baselines/walls.h"

namespace walkgraph {
namespace {

// Half of the sixteen directions; the other half are the same links backwards.
constexpr std::array<ReferencePoints::Cell, 8> kDirections{
    {{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {2, 1}, {1, 2}, {-1, 2}, {-2, 1}}};

struct Link {
  int to = 0;
  double length_m = 0;
};

std::vector<std::vector<Link>> FindLinks(const ReferencePoints& points,
                                         std::span<const Polygon> obstacles) {
  std::vector<std::vector<Link>> links(points.size());
  const Walls walls(obstacles);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ReferencePoints::Cell& from = points.cell(i);
    for (const ReferencePoints::Cell& step : kDirections) {
      const int j = points.IndexAt({from.column + step.column, from.row + step.row});
      if (j < 0) continue;
      const Eigen::Vector2d& a = points.positions_m()[i];
      const Eigen::Vector2d& b = points.positions_m()[static_cast<std::size_t>(j)];
      if (walls.Block(a, b)) continue;
      const double length_m = (b - a).norm();
      links[i].push_back({j, length_m});
      links[static_cast<std::size_t>(j)].push_back({static_cast<int>(i), length_m});
    }
  }
  return links;
}

// Dijkstra from one point; `shortest_m` is scratch space of one infinity per point, left so.
std::vector<WalkableWay> WaysFrom(int from, const ReferencePoints& points,
                                  const std::vector<std::vector<Link>>& links,
                                  double max_distance_m, std::vector<double>* shortest_m) {
  using Front = std::pair<double, int>;
  std::priority_queue<Front, std::vector<Front>, std::greater<>> front;
  std::vector<double>& shortest = *shortest_m;
  std::vector<WalkableWay> ways;
  shortest[static_cast<std::size_t>(from)] = 0;
  front.emplace(0.0, from);
  std::vector<int> touched{from};
  while (!front.empty()) {
    const auto [distance_m, at] = front.top();
    front.pop();
    if (distance_m > shortest[static_cast<std::size_t>(at)]) continue;
    const Eigen::Vector2d straight = points.positions_m()[static_cast<std::size_t>(at)] -
                                     points.positions_m()[static_cast<std::size_t>(from)];
    ways.push_back({at, distance_m, std::atan2(straight.y(), straight.x())});
    for (const Link& link : links[static_cast<std::size_t>(at)]) {
      double& best = shortest[static_cast<std::size_t>(link.to)];
      const double length_m = distance_m + link.length_m;
      if (length_m >= best || length_m > max_distance_m) continue;
      if (std::isinf(best)) touched.push_back(link.to);
      best = length_m;
      front.emplace(length_m, link.to);
    }
  }
  for (const int i : touched) {
    shortest[static_cast<std::size_t>(i)] = std::numeric_limits<double>::infinity();
  }
  std::sort(ways.begin(), ways.end(),
            [](const WalkableWay& a, const WalkableWay& b) { return a.to < b.to; });
  return ways;
}

}  // namespace

std::vector<std::vector<WalkableWay>> FindWalkableWays(const ReferencePoints& points,
                                                       std::span<const Polygon> obstacles,
                                                       double max_distance_m) {
  const std::vector<std::vector<Link>> links = FindLinks(points, obstacles);
  std::vector<double> shortest_m(points.size(), std::numeric_limits<double>::infinity());
  std::vector<std::vector<WalkableWay>> ways;
  ways.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    ways.push_back(WaysFrom(static_cast<int>(i), points, links, max_distance_m, &shortest_m));
  }
  return ways;
}

}  // namespace walkgraph
