#include "eval/run_walk.h"

#include <glog/logging.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <exception>

#include "eval/files.h"
#include "eval/result_files.h"
#include "eval/survey_distance.h"
#include "frontends/radio_map/reading_lag.h"
#include "frontends/radio_map/survey_positions.h"
#include "graph/motion_model.h"
#include "solvers/baselines/tcpf/trusted_points.h"

namespace walkgraph {
namespace {

using Clock = std::chrono::steady_clock;

bool IsFinite(const PoseEstimate& pose) {
  return pose.position_m.allFinite() && std::isfinite(pose.heading_rad);
}

// `evidence` is the walk's, aligned to the site.
MethodOutcome Score(const WalkRunOptions& options, const Site& site, const Estimator& estimator,
                    const std::string& method, const LoadedWalk& walk, const Evidence& evidence) {
  MethodOutcome outcome;
  if (!walk.error.empty()) {
    outcome.status = EstimateStatus::kInputError;
    outcome.messages = {walk.error};
    return outcome;
  }
  const Clock::time_point begin = Clock::now();
  const EstimateResult result = RunMethod(estimator, site, evidence, walk.truth);
  outcome.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  outcome.status = result.status;
  outcome.messages = walk.notes;
  outcome.messages.insert(outcome.messages.end(), result.messages.begin(), result.messages.end());
  outcome.has_trajectory = !result.trajectory.empty();
  if (outcome.has_trajectory) {
    outcome.errors = ErrorsAtWaypoints(result.trajectory, walk.truth, options.waypoint_sigma_m);
    outcome.trusted = TrustedAt(result, walk.truth.waypoints);
  }
  WriteEstimate(options.out, walk.file.id, evidence, method, result, options.tum);
  for (const std::string& message : result.messages) {
    LOG(INFO) << walk.file.id << " " << method << ": " << message;
  }
  return outcome;
}

}  // namespace

std::vector<WaypointError> CentroidErrors(const Site& site, const LoadedWalk& walk) {
  if (walk.truth.waypoints.empty()) return {};
  const int floor = walk.evidence.floor.value_or(walk.truth.waypoints.front().floor);
  const Eigen::Vector2d centroid = SurveyMean(site, floor).value_or(Eigen::Vector2d::Zero());
  return ErrorsOfFixedPoint(centroid, floor, walk.truth);
}

EstimateResult RunMethod(const Estimator& estimator, const Site& site, const Evidence& evidence,
                         const Truth& truth) {
  EstimateResult result;
  try {
    result = estimator.uses_truth()
                 ? estimator.EstimateKnowing(SurveyTrajectory(truth, evidence), site, evidence)
                 : estimator.Estimate(site, evidence);
  } catch (const std::exception& error) {
    result = EstimateResult();
    result.status = EstimateStatus::kDiverged;
    result.messages.push_back(error.what());
  }
  const std::vector<PoseEstimate>& poses = result.trajectory.poses;
  if (!std::all_of(poses.begin(), poses.end(), IsFinite)) {
    result.status = EstimateStatus::kDiverged;
    result.messages.emplace_back("a pose is not finite");
    result.trajectory = Trajectory();
  }
  return result;
}

WalkOutcome RunWalk(const WalkRunOptions& options, const Site& site,
                    const std::vector<std::unique_ptr<Estimator>>& estimators,
                    const LoadedWalk& walk, int fold) {
  WalkOutcome outcome;
  outcome.walk = walk.file.id;
  outcome.fold = fold;
  outcome.truth = walk.truth;
  for (const Waypoint& waypoint : walk.truth.waypoints) {
    outcome.motion.push_back(MotionStateAt(walk.evidence, waypoint.time_ns));
  }
  outcome.duration_s = SecondsBetween(walk.evidence.begin_ns, walk.evidence.end_ns);
  outcome.survey_distance_m = SurveyDistance(site, walk.truth);
  outcome.centroid_errors = CentroidErrors(site, walk);
  const Evidence evidence = AlignReadings(site, walk.evidence);
  for (std::size_t i = 0; i < estimators.size(); ++i) {
    outcome.methods.push_back(
        Score(options, site, *estimators[i], options.methods[i], walk, evidence));
  }
  WriteFileWhole(options.out + "/walks/" + walk.file.id + ".json",
                 FormatWalkJson(outcome, options.methods));
  outcome.finished = true;
  return outcome;
}

}  // namespace walkgraph
