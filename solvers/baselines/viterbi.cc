#include "solvers/baselines/viterbi.h"

#include <optional>
#include <set>
#include <vector>

namespace walkgraph {
namespace {

std::set<TimeNs> PoseTimes(const Evidence& evidence) {
  std::set<TimeNs> times{evidence.end_ns};
  for (TimeNs t = evidence.begin_ns; t < evidence.end_ns; t += kNsPerSecond) times.insert(t);
  for (const StepEvidence& step : evidence.steps) times.insert(step.end_ns);
  return times;
}

Eigen::Vector2d MiddleOfSurvey(const Site& site, int floor) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  for (const SurveyPoint& point : site.path) {
    if (point.floor != floor) continue;
    sum += point.position_m;
    ++count;
  }
  return count > 0 ? Eigen::Vector2d(sum / count) : sum;
}

PoseEstimate MakePose(TimeNs time_ns, const Eigen::Vector2d& position_m, int floor,
                      double heading_rad) {
  PoseEstimate pose;
  pose.time_ns = time_ns;
  pose.position_m.head<2>() = position_m;
  pose.floor = floor;
  pose.heading_rad = heading_rad;
  return pose;
}

}  // namespace

EstimateResult Viterbi::Estimate(const Site& site, const Evidence& evidence) const {
  EstimateResult result;
  const DeadReckonedPath walk = DeadReckon(site, evidence, factors_);
  std::vector<int> floors = site.SurveyedFloors();
  if (evidence.floor) floors = {*evidence.floor};
  if (floors.empty()) {
    result.status = EstimateStatus::kUnsupported;
    result.messages.emplace_back("the site has no radio map");
    return result;
  }
  std::optional<DiscretePath> best;
  int floor = floors.front();
  for (const int candidate : floors) {
    std::vector<DiscretePath> paths =
        SmoothOnLattice(site, evidence, walk, factors_, settings_, candidate);
    if (paths.empty()) continue;
    if (best && paths.front().negative_log_posterior >= best->negative_log_posterior) continue;
    best = std::move(paths.front());
    floor = candidate;
  }
  if (!best) {
    result.status = EstimateStatus::kUnobservable;
    result.messages.emplace_back(
        "position unobservable: no reading that the site knows and no position anchor");
  }
  const Eigen::Vector2d middle = MiddleOfSurvey(site, floor);
  for (const TimeNs time : PoseTimes(evidence)) {
    const Eigen::Vector2d position =
        best ? best->PositionAt(walk, time) : Eigen::Vector2d(middle + walk.PositionAt(time));
    const double offset = best ? Interpolate(best->heading_offset_rad, time) : 0.0;
    result.trajectory.poses.push_back(
        MakePose(time, position, floor, walk.HeadingAt(time) + offset));
  }
  return result;
}

}  // namespace walkgraph
