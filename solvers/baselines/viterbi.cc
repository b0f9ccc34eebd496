#include "solvers/baselines/viterbi.h"

#include <set>
#include <vector>

#include "factors/stair_steps.h"
#include "solvers/baselines/fixes.h"
#include "solvers/baselines/floor_tracker.h"

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

}  // namespace

EstimateResult Viterbi::Estimate(const Site& site, const Evidence& recorded) const {
  EstimateResult result;
  if (site.SurveyedFloors().empty()) {
    result.status = EstimateStatus::kUnsupported;
    result.messages.emplace_back("the site has no radio map");
    return result;
  }
  const FloorPath floors = TrackFloors(site, recorded, factors_).path;
  Evidence evidence = recorded;
  ShortenStairSteps(floors, factors_.step, &evidence);
  const DeadReckonedPath walk = DeadReckon(site, evidence, factors_);
  const std::vector<DiscretePath> paths =
      SmoothOnLattice(site, evidence, walk, factors_, settings_, floors);
  if (paths.empty()) {
    result.status = EstimateStatus::kUnobservable;
    result.messages.emplace_back(
        "position unobservable: no reading that the site knows and no position anchor");
  }
  const Eigen::Vector2d middle = MiddleOfSurvey(site, floors.Main());
  for (const TimeNs time : PoseTimes(evidence)) {
    PoseEstimate pose;
    pose.time_ns = time;
    pose.floor = floors.At(time);
    pose.position_m.z() = FloorHeight(site, pose.floor);
    pose.position_m.head<2>() = paths.empty() ? Eigen::Vector2d(middle + walk.PositionAt(time))
                                              : paths.front().PositionAt(walk, time);
    pose.heading_rad = walk.HeadingAt(time) +
                       (paths.empty() ? 0.0 : Interpolate(paths.front().heading_offset_rad, time));
    result.trajectory.poses.push_back(pose);
  }
  return result;
}

}  // namespace walkgraph
