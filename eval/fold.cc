#include "eval/fold.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <exception>

#include "eval/calibrate/calibrate_motion.h"
#include "eval/cross_validation.h"
#include "frontends/radio_map/survey_positions.h"
#include "frontends/radio_map/trainer.h"

namespace walkgraph {
namespace {

bool IsFinite(const PoseEstimate& pose) {
  return pose.position_m.allFinite() && std::isfinite(pose.heading_rad);
}

}  // namespace

Fold PrepareFold(const Building& building, const std::vector<const LoadedWalk*>& training,
                 const std::vector<const LoadedWalk*>& test,
                 const std::vector<const Method*>& methods,
                 const std::vector<ConfigOverride>& overrides) {
  HeardReadings heard_in_test;
  for (const LoadedWalk* walk : test) heard_in_test.Add(walk->evidence);
  heard_in_test.Freeze();

  std::deque<Evidence> evidence;  // keeps the addresses that the survey walks point to
  std::vector<SurveyWalk> survey;
  std::vector<CalibrationWalk> calibration;
  for (const LoadedWalk* walk : training) {
    if (!walk->error.empty() || walk->truth.waypoints.empty()) continue;
    evidence.push_back(walk->evidence);
    heard_in_test.RemoveFrom(&evidence.back());
    survey.push_back({&evidence.back(), SurveyTrajectory(walk->truth, walk->evidence)});
    calibration.push_back({&evidence.back(), &walk->truth});
  }

  Fold fold;
  CalibrateMotion(building, calibration, &fold.settings.factors);
  ApplyOverrides(overrides, &fold.settings);
  fold.site = TrainSite(building, survey, fold.settings.radio_map);
  for (const Method* method : methods) fold.estimators.push_back(method->make(fold.settings));
  return fold;
}

EstimateResult RunMethod(const Estimator& estimator, const Site& site, const Evidence& evidence) {
  EstimateResult result;
  try {
    result = estimator.Estimate(site, evidence);
  } catch (const std::exception& error) {
    result = EstimateResult();
    result.status = EstimateStatus::kDiverged;
    result.messages.push_back(error.what());
  }
  const std::vector<PoseEstimate>& poses = result.trajectory.poses;
  if (!std::all_of(poses.begin(), poses.end(), IsFinite)) {
    result.status = EstimateStatus::kDiverged;
    result.messages.push_back("a pose is not finite");
    result.trajectory = Trajectory();
  }
  return result;
}

}  // namespace walkgraph
