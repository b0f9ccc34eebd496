#ifndef WALKGRAPH_SOLVERS_BASELINES_WAY_GRAPH_H_
#define WALKGRAPH_SOLVERS_BASELINES_WAY_GRAPH_H_

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "data/building.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// The ways of a floor as its survey walks show them, where the building does not know them. Survey
// points are gathered into nodes: a point within `merge_m` of the first point of a node belongs to
// it (of several, to the nearest), and the node lies at the mean of its points. Nodes that a survey
// walk visits one after the other are linked. A node between two links that turn by less than
// `straight_rad` is no junction and is left out. Empty where nothing was surveyed.
WayNetwork WaysFromSurvey(std::span<const SurveyPoint> path, int floor, double merge_m,
                          double straight_rad);

// The building's ways on the floor, else those of the survey.
WayNetwork FindWays(const Site& site, int floor, double merge_m, double straight_rad);

// A place on a way network.
struct WayPosition {
  std::size_t link = 0;
  double along_m = 0;  // from the link's first node
};

// A place that can be reached, and the direction of travel there (unit vector).
struct WayCandidate {
  WayPosition at;
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
};

// Movement on a way network.
class WayGraph {
 public:
  // Links without length are left out.
  explicit WayGraph(const WayNetwork& ways);

  bool empty() const { return links_.empty(); }
  std::size_t link_count() const { return links_.size(); }

  Eigen::Vector2d PositionOf(const WayPosition& at) const;
  // The nearest place of the network. Precondition: not empty().
  WayPosition Project(const Eigen::Vector2d& position_m) const;

  // Where somebody may be after `distance_m` (>= 0) from a place: one per direction of travel on a
  // link, one per link beyond every node that the distance runs past. Nobody turns round at a node;
  // at a dead end people stop. Each node is passed on the shortest way to it.
  std::vector<WayCandidate> Reach(const WayPosition& from, double distance_m) const;

 private:
  struct Link {
    int from = 0, to = 0;
    Eigen::Vector2d start_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
    double length_m = 0;
    int OtherEnd(int node) const { return node == from ? to : from; }
  };
  // Arrival at a node along a link.
  struct Arrival {
    int node = 0;
    std::size_t link = 0;
    double distance_m = 0;
  };

  // Somebody on the link who walks towards its end at `node` and is `rest_m` from it.
  WayCandidate BeforeNode(std::size_t link, int node, double rest_m) const;

  std::vector<Link> links_;
  std::vector<std::vector<std::size_t>> links_of_node_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_WAY_GRAPH_H_
