#include "solvers/baselines/way_graph.h"

#include <algorithm>
#include <limits>

namespace walkgraph {

Eigen::Vector2d WayGraph::PositionOf(const WayPosition& at) const {
  const Link& link = links_[at.link];
  return link.start_m + at.along_m * link.direction;
}

WayGraph::WayGraph(const WayNetwork& ways) : links_of_node_(ways.nodes.size()) {
  for (const auto& [from, to] : ways.links) {
    const Eigen::Vector2d start = ways.nodes[static_cast<std::size_t>(from)];
    const Eigen::Vector2d span = ways.nodes[static_cast<std::size_t>(to)] - start;
    const double length_m = span.norm();
    if (length_m == 0) continue;
    links_of_node_[static_cast<std::size_t>(from)].push_back(links_.size());
    links_of_node_[static_cast<std::size_t>(to)].push_back(links_.size());
    links_.push_back({from, to, start, span / length_m, length_m});
  }
}

WayPosition WayGraph::Project(const Eigen::Vector2d& position_m) const {
  WayPosition nearest;
  double nearest_m2 = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    const Eigen::Vector2d offset = position_m - link.start_m;
    const double along_m = std::clamp(offset.dot(link.direction), 0.0, link.length_m);
    const double m2 = (offset - along_m * link.direction).squaredNorm();
    if (m2 >= nearest_m2) continue;
    nearest_m2 = m2;
    nearest = {i, along_m};
  }
  return nearest;
}

WayCandidate WayGraph::BeforeNode(std::size_t link, int node, double rest_m) const {
  const Link& way = links_[link];
  if (node == way.to) return {{link, way.length_m - rest_m}, way.direction};
  return {{link, rest_m}, -way.direction};
}

std::vector<WayCandidate> WayGraph::Reach(const WayPosition& from, double distance_m) const {
  std::vector<WayCandidate> reached;
  std::vector<Arrival> open;
  // Down a link: either the way ends on it, or it leads to the node at its end.
  const auto travel = [&](std::size_t link, int towards, double begin_m, double rest_m) {
    const double left_m = distance_m - begin_m;
    if (left_m <= rest_m) {
      reached.push_back(BeforeNode(link, towards, rest_m - left_m));
    } else {
      open.push_back({towards, link, begin_m + rest_m});
    }
  };
  const Link& start = links_[from.link];
  travel(from.link, start.to, 0, start.length_m - from.along_m);
  travel(from.link, start.from, 0, from.along_m);

  std::vector<int> passed;
  while (!open.empty()) {
    const auto first = std::min_element(
        open.begin(), open.end(),
        [](const Arrival& a, const Arrival& b) { return a.distance_m < b.distance_m; });
    const Arrival arrival = *first;
    open.erase(first);
    if (std::find(passed.begin(), passed.end(), arrival.node) != passed.end()) continue;
    passed.push_back(arrival.node);
    const std::vector<std::size_t>& links = links_of_node_[static_cast<std::size_t>(arrival.node)];
    if (links.size() == 1) reached.push_back(BeforeNode(arrival.link, arrival.node, 0));
    for (const std::size_t link : links) {
      if (link == arrival.link) continue;
      travel(link, links_[link].OtherEnd(arrival.node), arrival.distance_m, links_[link].length_m);
    }
  }
  return reached;
}

}  // namespace walkgraph
