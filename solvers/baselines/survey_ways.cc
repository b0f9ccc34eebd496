#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include "data/angle.h"
#include "solvers/baselines/way_graph.h"

namespace walkgraph {
namespace {

using NeighbourSets = std::vector<std::set<int>>;

// Survey points gathered around the first point of each node.
class NodeBuilder {
 public:
  explicit NodeBuilder(double merge_m) : merge_m_(merge_m) {}

  // The node that a point belongs to, made if need be.
  int Add(const Eigen::Vector2d& point) {
    int nearest = -1;
    double nearest_m = merge_m_;
    for (std::size_t i = 0; i < seeds_.size(); ++i) {
      const double m = (seeds_[i] - point).norm();
      if (m > nearest_m) continue;
      nearest_m = m;
      nearest = static_cast<int>(i);
    }
    if (nearest < 0) {
      nearest = static_cast<int>(seeds_.size());
      seeds_.push_back(point);
      sums_.emplace_back(Eigen::Vector2d::Zero());
      counts_.push_back(0);
    }
    sums_[static_cast<std::size_t>(nearest)] += point;
    ++counts_[static_cast<std::size_t>(nearest)];
    return nearest;
  }

  std::vector<Eigen::Vector2d> Means() const {
    std::vector<Eigen::Vector2d> means = sums_;
    for (std::size_t i = 0; i < means.size(); ++i) means[i] /= counts_[i];
    return means;
  }

 private:
  double merge_m_;
  std::vector<Eigen::Vector2d> seeds_, sums_;
  std::vector<int> counts_;
};

double Turn(const Eigen::Vector2d& before, const Eigen::Vector2d& at,
            const Eigen::Vector2d& after) {
  const Eigen::Vector2d in = at - before, out = after - at;
  return std::abs(WrapAngle(std::atan2(out.y(), out.x()) - std::atan2(in.y(), in.x())));
}

// Takes out the nodes between two links that lead nearly straight on.
void JoinStraightLinks(const std::vector<Eigen::Vector2d>& nodes, double straight_rad,
                       NeighbourSets* neighbours) {
  const auto place = [&](int node) { return nodes[static_cast<std::size_t>(node)]; };
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::set<int>& ends = (*neighbours)[i];
    if (ends.size() != 2) continue;
    const int a = *ends.begin(), b = *ends.rbegin();
    if (Turn(place(a), nodes[i], place(b)) >= straight_rad) continue;
    for (const auto& [end, other] : {std::pair(a, b), std::pair(b, a)}) {
      std::set<int>& of_end = (*neighbours)[static_cast<std::size_t>(end)];
      of_end.erase(static_cast<int>(i));
      of_end.insert(other);
    }
    ends.clear();
  }
}

// The nodes that have links, renumbered.
WayNetwork Compact(const std::vector<Eigen::Vector2d>& nodes, const NeighbourSets& neighbours) {
  WayNetwork ways;
  std::vector<int> number(nodes.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (neighbours[i].empty()) continue;
    number[i] = static_cast<int>(ways.nodes.size());
    ways.nodes.push_back(nodes[i]);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const int j : neighbours[i]) {
      if (static_cast<int>(i) < j) {
        ways.links.push_back({number[i], number[static_cast<std::size_t>(j)]});
      }
    }
  }
  return ways;
}

}  // namespace

WayNetwork WaysFromSurvey(std::span<const SurveyPoint> path, int floor, double merge_m,
                          double straight_rad) {
  NodeBuilder builder(merge_m);
  NeighbourSets neighbours;
  int last = -1;
  const SurveyPoint* last_point = nullptr;
  for (const SurveyPoint& point : path) {
    if (point.floor != floor) {
      last_point = nullptr;
      continue;
    }
    const int node = builder.Add(point.position_m);
    neighbours.resize(std::max(neighbours.size(), static_cast<std::size_t>(node) + 1));
    if (last_point != nullptr && last_point->walk == point.walk && last != node) {
      neighbours[static_cast<std::size_t>(last)].insert(node);
      neighbours[static_cast<std::size_t>(node)].insert(last);
    }
    last = node;
    last_point = &point;
  }
  const std::vector<Eigen::Vector2d> nodes = builder.Means();
  JoinStraightLinks(nodes, straight_rad, &neighbours);
  return Compact(nodes, neighbours);
}

WayNetwork FindWays(const Site& site, int floor, double merge_m, double straight_rad) {
  const Floor* known = site.building.FindFloor(floor);
  if (known != nullptr && !known->ways.empty()) return known->ways;
  return WaysFromSurvey(site.path, floor, merge_m, straight_rad);
}

}  // namespace walkgraph
