#include "solvers/initial_trajectory.h"

#include <utility>

#include "factors/dead_reckoning.h"
#include "graph/node_times.h"
#include "graph/walk_graph.h"
#include "solvers/baselines/discrete_smoother.h"
#include "solvers/placement.h"

namespace walkgraph {
namespace {

// Builds a trajectory at the graph's nodes from position(t) and heading(t).
template <typename Position, typename Heading>
Trajectory Sample(const Evidence& evidence, const FloorPath& floors, const Position& position,
                  const Heading& heading) {
  Trajectory trajectory;
  for (const TimeNs time : GraphNodeTimes(evidence)) {
    PoseEstimate pose;
    pose.time_ns = time;
    pose.floor = floors.At(time);
    pose.position_m.head<2>() = position(time);
    pose.heading_rad = heading(time);
    trajectory.poses.push_back(pose);
  }
  return trajectory;
}

Trajectory FromPlacement(const Evidence& evidence, const DeadReckonedPath& walk,
                         const FloorPath& floors, const Placement& placement) {
  return Sample(
      evidence, floors, [&](TimeNs time) { return placement.At(walk, time); },
      [&](TimeNs time) { return walk.HeadingAt(time) + placement.rotation_rad; });
}

Trajectory FromLattice(const Evidence& evidence, const DeadReckonedPath& walk,
                       const FloorPath& floors, const DiscretePath& path) {
  return Sample(
      evidence, floors, [&](TimeNs time) { return path.PositionAt(walk, time); },
      [&](TimeNs time) {
        return walk.HeadingAt(time) + Interpolate(path.heading_offset_rad, time);
      });
}

// The walk laid so that its mean over time is the middle of the floor.
Placement AboutTheMiddle(const Site& site, const Evidence& evidence, const DeadReckonedPath& walk,
                         const FloorPath& floors) {
  Placement placement;
  const std::vector<TimeNs> times = GraphNodeTimes(evidence);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const TimeNs time : times) mean += walk.PositionAt(time) / static_cast<double>(times.size());
  placement.start_m = FloorCentre(site, floors.Main()) - mean;
  return placement;
}

}  // namespace

std::vector<InitialTrajectory> ProposeTrajectories(const Site& site, const Evidence& evidence,
                                                   const FactorSettings& factors,
                                                   const FloorPath& floors, int placements) {
  const DeadReckonedPath walk = DeadReckon(site, evidence, factors);
  std::vector<InitialTrajectory> proposals;
  const auto add = [&proposals](std::string source, Trajectory trajectory) {
    proposals.push_back({std::move(source), std::move(trajectory)});
  };
  int rank = 0;
  for (const DiscretePath& path :
       SmoothOnLattice(site, evidence, walk, factors, DiscreteSettings{}, floors)) {
    add("viterbi " + std::to_string(++rank), FromLattice(evidence, walk, floors, path));
  }
  rank = 0;
  for (const Placement& placement :
       PlaceDeadReckoning(site, evidence, walk, factors, floors, placements)) {
    add("dead_reckoning " + std::to_string(++rank),
        FromPlacement(evidence, walk, floors, placement));
  }
  if (proposals.empty()) {
    add("dead_reckoning",
        FromPlacement(evidence, walk, floors, AboutTheMiddle(site, evidence, walk, floors)));
  }
  return proposals;
}

}  // namespace walkgraph
