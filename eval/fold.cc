#include "eval/fold.h"

#include <glog/logging.h>

#include <cstddef>
#include <deque>
#include <utility>

#include "eval/calibrate/calibrate_motion.h"
#include "eval/cross_validation.h"
#include "eval/survey_placement.h"
#include "frontends/radio_map/trainer.h"

namespace walkgraph {
namespace {

std::vector<SurveyWalk> PlaceSurvey(const Building& building,
                                    const std::vector<CalibrationWalk>& walks,
                                    const std::vector<std::string>& trials,
                                    const Settings& settings, const Executor& run) {
  std::vector<SurveyPlacement> placements(walks.size());
  run(walks.size(), [&](std::size_t i) {
    placements[i] = PlaceSurveyWalk(building, *walks[i].truth, *walks[i].evidence, settings);
  });
  std::vector<SurveyWalk> survey;
  std::size_t fell_back = 0;
  for (std::size_t i = 0; i < walks.size(); ++i) {
    fell_back += placements[i].fell_back ? 1 : 0;
    survey.push_back({walks[i].evidence, std::move(placements[i].trajectory), trials[i]});
  }
  if (fell_back > 0) {
    LOG(INFO) << "survey positions: " << fell_back << " of " << walks.size()
              << " walks by walked distance, as the smoother has no answer for them";
  }
  return survey;
}

}  // namespace

std::vector<int> AssignFolds(const std::vector<const LoadedWalk*>& walks, SplitBy split,
                             int folds) {
  std::vector<WalkToSplit> to_split;
  for (const LoadedWalk* walk : walks) {
    to_split.push_back({walk->file.id, walk->file.trial, walk->evidence.device, &walk->truth});
  }
  std::vector<int> fold_of_walk;
  for (const std::string& group : GroupWalks(to_split, split)) {
    fold_of_walk.push_back(FoldOfGroup(group, folds));
  }
  return fold_of_walk;
}

Fold PrepareFold(const Building& building, const std::vector<const LoadedWalk*>& training,
                 const std::vector<const LoadedWalk*>& test,
                 const std::vector<ConfigOverride>& overrides, const Executor& run) {
  HeardReadings heard_in_test;
  for (const LoadedWalk* walk : test) heard_in_test.Add(walk->evidence);
  heard_in_test.Freeze();

  std::deque<Evidence> evidence;  // keeps the addresses that the walks point to
  std::vector<CalibrationWalk> walks;
  std::vector<std::string> trials;
  for (const LoadedWalk* walk : training) {
    if (!walk->error.empty() || walk->truth.waypoints.empty()) continue;
    evidence.push_back(walk->evidence);
    heard_in_test.RemoveFrom(&evidence.back());
    walks.push_back({&evidence.back(), &walk->truth});
    trials.push_back(walk->file.trial);
  }

  Fold fold;
  CalibrateMotion(building, walks, &fold.settings.factors);
  ApplyOverrides(overrides, &fold.settings);
  fold.site = TrainSite(building, PlaceSurvey(building, walks, trials, fold.settings, run),
                        fold.settings.radio_map, run);
  return fold;
}

}  // namespace walkgraph
