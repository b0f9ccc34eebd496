#include "frontends/radio_map/survey_positions.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "data/angle.h"

namespace walkgraph {
namespace {

// A waypoint is a mark on the floor that a person taps while passing: about a step's half width.
constexpr double kWaypointSigmaM = 0.3;
// Between waypoints d metres apart the error by walked distance is that of a Brownian bridge with
// this rate: 0.35 m sqrt(metre) gives about 0.8 m in the middle of a 20 m leg.
constexpr double kBridgeRate = 0.35;

// Metres walked by a time, from the detected steps; linear within a step.
class WalkedDistance {
 public:
  explicit WalkedDistance(const std::vector<StepEvidence>& steps) {
    for (const StepEvidence& step : steps) {
      Append(step.begin_ns, 0.0);
      Append(step.end_ns, step.length_m);
    }
  }

  double At(TimeNs time_ns) const { return metres_.empty() ? 0.0 : Interpolate(metres_, time_ns); }

 private:
  void Append(TimeNs time_ns, double metres) {
    const double total = metres_.empty() ? metres : metres_.value.back() + metres;
    if (!metres_.empty() && metres_.time_ns.back() >= time_ns) {
      metres_.value.back() = total;
      return;
    }
    metres_.push_back(time_ns, total);
  }

  Stream<double> metres_;
};

double ShareOfLeg(const WalkedDistance& walked, TimeNs begin, TimeNs end, TimeNs time) {
  const double whole = walked.At(end) - walked.At(begin);
  const double by_time = SecondsBetween(begin, time) / SecondsBetween(begin, end);
  if (whole <= 0.0) return by_time;
  return (walked.At(time) - walked.At(begin)) / whole;
}

PoseEstimate PoseOnLeg(const Waypoint& from, const Waypoint& to, TimeNs time, double share) {
  PoseEstimate pose;
  pose.time_ns = time;
  pose.position_m.head<2>() = from.position + share * (to.position - from.position);
  pose.floor = share < 0.5 ? from.floor : to.floor;
  const Eigen::Vector2d leg = to.position - from.position;
  pose.heading_rad = std::atan2(leg.y(), leg.x());
  const double bridge = kBridgeRate * kBridgeRate * leg.norm() * share * (1.0 - share);
  const double variance = kWaypointSigmaM * kWaypointSigmaM + bridge;
  pose.covariance_xy_m2 = variance * Eigen::Matrix2d::Identity();
  return pose;
}

std::set<TimeNs> PoseTimes(const Truth& truth, const Evidence& evidence) {
  const TimeNs first = truth.waypoints.front().time_ns;
  const TimeNs last = truth.waypoints.back().time_ns;
  std::set<TimeNs> times;
  for (const Waypoint& waypoint : truth.waypoints) times.insert(waypoint.time_ns);
  for (TimeNs t = first; t < last; t += kNsPerSecond) times.insert(t);
  for (const StepEvidence& step : evidence.steps) {
    if (step.end_ns > first && step.end_ns < last) times.insert(step.end_ns);
  }
  return times;
}

}  // namespace

Trajectory SurveyTrajectory(const Truth& truth, const Evidence& evidence) {
  Trajectory trajectory;
  if (truth.waypoints.empty()) return trajectory;
  const WalkedDistance walked(evidence.steps);
  std::size_t leg = 0;
  for (const TimeNs time : PoseTimes(truth, evidence)) {
    while (leg + 2 < truth.waypoints.size() && truth.waypoints[leg + 1].time_ns <= time) ++leg;
    const Waypoint& from = truth.waypoints[leg];
    const Waypoint& to = truth.waypoints[std::min(leg + 1, truth.waypoints.size() - 1)];
    const bool whole_leg = to.time_ns > from.time_ns;
    const double share =
        whole_leg ? std::clamp(ShareOfLeg(walked, from.time_ns, to.time_ns, time), 0.0, 1.0) : 0.0;
    PoseEstimate pose = PoseOnLeg(from, to, time, share);
    if (!trajectory.empty()) {
      const double before = trajectory.poses.back().heading_rad;
      pose.heading_rad = before + WrapAngle(pose.heading_rad - before);
    }
    trajectory.poses.push_back(pose);
  }
  return trajectory;
}

}  // namespace walkgraph
