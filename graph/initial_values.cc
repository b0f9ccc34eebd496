#include <algorithm>
#include <cstddef>

#include "graph/node_times.h"
#include "graph/walk_graph.h"

namespace walkgraph {

void SetTrajectory(const Trajectory& trajectory, WalkGraph* walk) {
  walk->graph.SetValues(walk->prior_values);
  if (trajectory.empty()) return;
  std::vector<TimeNs> times;
  for (const PoseEstimate& pose : trajectory.poses) times.push_back(pose.time_ns);
  for (std::size_t i = 0; i < walk->node_ns.size(); ++i) {
    const NodeBracket bracket = FindBracket(times, walk->node_ns[i]);
    const auto before = static_cast<std::size_t>(bracket.before);
    const PoseEstimate& a = trajectory.poses[before];
    const PoseEstimate& b = trajectory.poses[bracket.fraction > 0 ? before + 1 : before];
    const Eigen::Vector3d position =
        (1.0 - bracket.fraction) * a.position_m + bracket.fraction * b.position_m;
    std::copy_n(position.data(), 2, walk->graph.value(walk->position[i]));
    *walk->graph.value(walk->heading[i]) =
        (1.0 - bracket.fraction) * a.heading_rad + bracket.fraction * b.heading_rad;
  }
}

Eigen::Vector2d FloorCentre(const Site& site, int floor) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  for (const SurveyPoint& point : site.path) {
    if (point.floor != floor) continue;
    sum += point.position_m;
    ++count;
  }
  if (count > 0) return sum / count;
  for (const Floor& candidate : site.building.floors) {
    if (candidate.number == floor) return 0.5 * (candidate.min_corner + candidate.max_corner);
  }
  return Eigen::Vector2d::Zero();
}

}  // namespace walkgraph
