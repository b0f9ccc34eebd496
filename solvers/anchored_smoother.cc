#include "solvers/anchored_smoother.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "factors/dead_reckoning.h"
#include "frontends/radio_map/survey_positions.h"
#include "graph/walk_graph.h"
#include "solvers/modes.h"

namespace walkgraph {
namespace {

bool OnOneFloor(const std::vector<Waypoint>& waypoints) {
  return std::all_of(waypoints.begin(), waypoints.end(), [&](const Waypoint& waypoint) {
    return waypoint.floor == waypoints.front().floor;
  });
}

// What the sensors say without the radios, and the waypoints.
Evidence Anchored(const Evidence& evidence, const std::vector<Waypoint>& waypoints,
                  double sigma_m) {
  Evidence anchored = evidence;
  anchored.readings.clear();
  anchored.anchors.clear();
  for (const Waypoint& waypoint : waypoints) {
    anchored.anchors.push_back({waypoint.time_ns, waypoint.position, waypoint.floor, sigma_m});
  }
  return anchored;
}

// Angle by which the dead-reckoned legs between waypoints have to be turned to lie on the true ones
// best, in the sense of least squares.
double RotationOntoWaypoints(const DeadReckonedPath& path, const std::vector<Waypoint>& waypoints) {
  double along = 0, across = 0;
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    const Eigen::Vector2d walked =
        path.PositionAt(waypoints[i].time_ns) - path.PositionAt(waypoints[i - 1].time_ns);
    const Eigen::Vector2d leg = waypoints[i].position - waypoints[i - 1].position;
    along += walked.dot(leg);
    across += walked.x() * leg.y() - walked.y() * leg.x();
  }
  return std::atan2(across, along);
}

// The headings decide which minimum a solve falls into: for given headings the rest is all but
// linear. Those of the straight legs miss every turn between waypoints, those of dead reckoning
// drift; a start of either kind, positions by walked distance in both.
std::vector<InitialTrajectory> Starts(const Site& site, const Truth& truth,
                                      const Evidence& evidence, const FactorSettings& factors) {
  const Trajectory straight = SurveyTrajectory(truth, evidence);
  const DeadReckonedPath path = DeadReckon(site, evidence, factors);
  const double rotation_rad = RotationOntoWaypoints(path, truth.waypoints);
  Trajectory reckoned = straight;
  for (PoseEstimate& pose : reckoned.poses) {
    pose.heading_rad = path.HeadingAt(pose.time_ns) + rotation_rad;
  }
  return {{"walked_distance", straight}, {"dead_reckoning", reckoned}};
}

// The denser of the minima that are reached from the starts; none where no solve succeeds.
std::optional<Mode> SolveBest(const std::vector<InitialTrajectory>& starts, const GraphPart& part,
                              const SolverSettings& solver, WalkGraph* walk) {
  std::optional<Mode> best;
  for (const InitialTrajectory& start : starts) {
    int failed_solves = 0;
    Mode mode = SolveFrom(start, part, solver, walk, &failed_solves);
    if (failed_solves > 0) continue;
    if (!best || mode.negative_log_density < best->negative_log_density) best = std::move(mode);
  }
  if (!best) return std::nullopt;
  walk->graph.SetValues(best->values);
  best->uncertainty = ComputeUncertainty(*walk, part, solver.map_error_test);
  // Where the graph cannot be inverted nothing is known of its error.
  if (!std::isfinite(best->uncertainty.log_det_hessian)) return std::nullopt;
  return best;
}

Trajectory Between(const Trajectory& whole, TimeNs begin_ns, TimeNs end_ns) {
  Trajectory part;
  part.poses.push_back(whole.At(begin_ns));
  for (const PoseEstimate& pose : whole.poses) {
    if (pose.time_ns > begin_ns && pose.time_ns < end_ns) part.poses.push_back(pose);
  }
  if (end_ns > begin_ns) part.poses.push_back(whole.At(end_ns));
  return part;
}

}  // namespace

std::optional<Trajectory> AnchoredSmoother::Smooth(const Building& building, const Truth& truth,
                                                   const Evidence& evidence) const {
  const std::vector<Waypoint>& waypoints = truth.waypoints;
  if (waypoints.size() < 2 || !OnOneFloor(waypoints) || evidence.steps.empty()) return std::nullopt;
  Site site;
  site.building = building;
  const int floor = waypoints.front().floor;
  WalkGraph walk =
      BuildWalkGraph(site, Anchored(evidence, waypoints, waypoint_sigma_m_), factors_, floor);
  const std::optional<Mode> mode =
      SolveBest(Starts(site, truth, evidence, factors_), WholeGraph(walk.graph), solver_, &walk);
  if (!mode) return std::nullopt;
  return Between(MixModes(walk, {*mode}, solver_.mode_limit_nats), waypoints.front().time_ns,
                 waypoints.back().time_ns);
}

}  // namespace walkgraph
