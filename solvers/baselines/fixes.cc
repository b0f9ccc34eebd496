#include "solvers/baselines/fixes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include "data/angle.h"

namespace walkgraph {
namespace {

// The floor with the longest survey path; else the first of the building; else 0.
int MainFloor(const Site& site) {
  std::map<int, int> points;
  for (const SurveyPoint& point : site.path) ++points[point.floor];
  if (points.empty()) return site.building.floors.empty() ? 0 : site.building.floors[0].number;
  return std::max_element(points.begin(), points.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

// Mean and covariance of a uniform distribution over the floor's bounding box.
void BoundingBoxMoments(const Site& site, PositionFix* fix) {
  fix->covariance_m2.setZero();
  for (const Floor& floor : site.building.floors) {
    if (floor.number != fix->floor) continue;
    const Eigen::Vector2d size = floor.max_corner - floor.min_corner;
    fix->position_m = floor.min_corner + size / 2;
    fix->covariance_m2 = (size.array().square() / 12).matrix().asDiagonal();
  }
}

double DirectionOfTravel(const std::vector<PositionFix>& fixes, std::size_t after) {
  if (fixes.size() < 2) return 0;
  const std::size_t to = std::clamp<std::size_t>(after, 1, fixes.size() - 1);
  const Eigen::Vector2d d = fixes[to].position_m - fixes[to - 1].position_m;
  return std::atan2(d.y(), d.x());
}

}  // namespace

std::vector<TimeNs> NodeTimes(const Evidence& evidence, std::vector<TimeNs> more) {
  std::erase_if(more, [&evidence](TimeNs time) {
    return time < evidence.begin_ns || time > evidence.end_ns;
  });
  for (TimeNs t = evidence.begin_ns; t < evidence.end_ns; t += kNsPerSecond) more.push_back(t);
  more.push_back(evidence.end_ns);
  std::sort(more.begin(), more.end());
  more.erase(std::unique(more.begin(), more.end()), more.end());
  return more;
}

Trajectory TrajectoryFromFixes(const Site& site, const Evidence& evidence,
                               const DeadReckonedPath& path,
                               const std::vector<PositionFix>& fixes) {
  std::vector<TimeNs> fix_times;
  fix_times.reserve(fixes.size());
  for (const PositionFix& fix : fixes) fix_times.push_back(fix.time_ns);

  Trajectory trajectory;
  double heading = 0;
  for (const TimeNs time : NodeTimes(evidence, fix_times)) {
    const auto next = std::lower_bound(fix_times.begin(), fix_times.end(), time);
    const auto after = static_cast<std::size_t>(next - fix_times.begin());
    const PositionFix& b = fixes[std::min(after, fixes.size() - 1)];
    const PositionFix& a = after == 0 || b.time_ns <= time ? b : fixes[after - 1];
    const double span_s = SecondsBetween(a.time_ns, b.time_ns);
    const double fraction = span_s > 0 ? SecondsBetween(a.time_ns, time) / span_s : 0;
    PoseEstimate pose;
    pose.time_ns = time;
    pose.floor = fraction < 0.5 ? a.floor : b.floor;
    pose.position_m.head<2>() = a.position_m + fraction * (b.position_m - a.position_m);
    pose.position_m.z() = FloorHeight(site, pose.floor);
    pose.covariance_xy_m2 = a.covariance_m2 + fraction * (b.covariance_m2 - a.covariance_m2);
    if (path.source == HeadingSource::kAbsolute) {
      heading = path.HeadingAt(time);
    } else {
      heading += WrapAngle(DirectionOfTravel(fixes, after) - heading);
    }
    pose.heading_rad = heading;
    trajectory.poses.push_back(pose);
  }
  return trajectory;
}

PositionFix SurveyCentroid(const Site& site, std::optional<int> floor) {
  PositionFix fix;
  fix.floor = floor.value_or(MainFloor(site));
  double count = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const SurveyPoint& point : site.path) {
    if (point.floor != fix.floor) continue;
    sum += point.position_m;
    ++count;
  }
  if (count == 0) {
    BoundingBoxMoments(site, &fix);
    return fix;
  }
  fix.position_m = sum / count;
  fix.covariance_m2.setZero();
  for (const SurveyPoint& point : site.path) {
    if (point.floor != fix.floor) continue;
    const Eigen::Vector2d d = point.position_m - fix.position_m;
    fix.covariance_m2 += d * d.transpose() / count;
  }
  return fix;
}

EstimateResult UnlocatedResult(const Site& site, const Evidence& evidence,
                               const DeadReckonedPath& path, const std::string& message) {
  EstimateResult result;
  result.status = EstimateStatus::kUnobservable;
  result.messages.push_back(message + ": placed at the centroid of the survey");
  PositionFix fix = SurveyCentroid(site, evidence.floor);
  fix.time_ns = evidence.begin_ns;
  result.trajectory = TrajectoryFromFixes(site, evidence, path, {fix});
  return result;
}

double FloorHeight(const Site& site, int floor) {
  for (const Floor& candidate : site.building.floors) {
    if (candidate.number == floor) return candidate.height_m;
  }
  return 0;
}

}  // namespace walkgraph
