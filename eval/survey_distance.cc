#include "eval/survey_distance.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace walkgraph {
namespace {

double DistanceToSegment(const Eigen::Vector2d& point, const Eigen::Vector2d& begin,
                         const Eigen::Vector2d& end) {
  const Eigen::Vector2d along = end - begin;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp((point - begin).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (begin + t * along - point).norm();
}

double DistanceToPath(const Site& site, const Waypoint& waypoint) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < site.path.size(); ++i) {
    const SurveyPoint& point = site.path[i];
    if (point.floor != waypoint.floor) continue;
    // Consecutive points of one walk are a stretch of its path.
    const bool connected =
        i > 0 && site.path[i - 1].walk == point.walk && site.path[i - 1].floor == point.floor;
    const Eigen::Vector2d& begin = connected ? site.path[i - 1].position_m : point.position_m;
    nearest = std::min(nearest, DistanceToSegment(waypoint.position, begin, point.position_m));
  }
  return nearest;
}

}  // namespace

double SurveyDistance(const Site& site, const Truth& truth) {
  if (truth.waypoints.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (const Waypoint& waypoint : truth.waypoints) sum += DistanceToPath(site, waypoint);
  return sum / static_cast<double>(truth.waypoints.size());
}

std::optional<Eigen::Vector2d> SurveyMean(const Site& site, int floor) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  for (const SurveyPoint& point : site.path) {
    if (point.floor != floor) continue;
    sum += point.position_m;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

}  // namespace walkgraph
