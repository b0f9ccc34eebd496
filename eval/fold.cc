#include "eval/fold.h"

#include <deque>

#include "eval/calibrate/calibrate_motion.h"
#include "eval/cross_validation.h"
#include "frontends/radio_map/survey_positions.h"
#include "frontends/radio_map/trainer.h"

namespace walkgraph {

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

}  // namespace walkgraph
