#include "eval/honesty/measure_honesty.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "data/dataset.h"
#include "eval/evaluate.h"
#include "eval/files.h"
#include "eval/fold.h"
#include "eval/honesty/honesty_figures.h"
#include "eval/honesty/honesty_output.h"
#include "eval/honesty/honesty_scores.h"
#include "eval/honesty/matched_site.h"
#include "eval/honesty/matched_walk.h"
#include "eval/loaded_walk.h"
#include "eval/parallel.h"
#include "eval/progress.h"
#include "eval/run_folder.h"
#include "graph/map_error_states.h"
#include "graph/statistics.h"
#include "graph/walk_graph.h"

namespace walkgraph {
namespace {

WalkHonesty Measure(const Estimator& estimator, const Site& site, const Evidence& evidence,
                    const Truth& truth, double truth_sigma_m) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  const EstimateResult estimate = estimator.Estimate(site, evidence);
  WalkHonesty walk;
  walk.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  walk.has_trajectory = !estimate.trajectory.empty();
  if (!walk.has_trajectory) return walk;
  walk.errors =
      ErrorsAtWaypoints(estimate.trajectory, ThinTruth(truth, kScoredEveryS), truth_sigma_m);
  walk.statistics = estimate.factor_statistics;
  walk.innovations = estimate.innovations;
  return walk;
}

std::vector<ResidualStatistics> StatisticsAtTruth(const Site& site, const FactorSettings& settings,
                                                  const MatchedWalk& drawn) {
  WalkGraph walk = BuildWalkGraph(site, drawn.evidence, settings, *drawn.evidence.floor);
  walk.graph.SetValues(drawn.values);
  ConditionOnPlaces(&walk);
  return ComputeStatistics(walk.graph);
}

HonestyResult EmptyResult(const HonestyOptions& options, std::vector<std::string> walks) {
  HonestyResult result;
  result.walks = std::move(walks);
  for (const Method* method : options.methods) result.methods.push_back(method->name);
  result.outcomes.assign(options.methods.size(), std::vector<WalkHonesty>(result.walks.size()));
  return result;
}

// The user's, and innovations where they say nothing else.
std::vector<ConfigOverride> Overrides(const HonestyOptions& options) {
  std::vector<ConfigOverride> overrides = {ParseSetFlag("window.innovations=true")};
  overrides.insert(overrides.end(), options.overrides.begin(), options.overrides.end());
  return overrides;
}

HonestyResult MeasureDrawn(const HonestyOptions& options) {
  Settings settings = MatchedSettings();
  ApplyOverrides(Overrides(options), &settings);
  const Random random(options.seed);
  const Site site = MakeMatchedSite(settings.factors.map_error.sigma_m, random.Fork(0));
  std::vector<std::unique_ptr<Estimator>> estimators;
  for (const Method* method : options.methods) estimators.push_back(method->make(settings));
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(options.walks));
  for (int i = 0; i < options.walks; ++i) names.push_back("drawn" + std::to_string(1000 + i));
  HonestyResult result = EmptyResult(options, names);
  std::vector<std::vector<ResidualStatistics>> at_truth(names.size());
  Progress progress(options.walks, "walks", options.out + "/run/progress");
  ParallelFor(options.workers, names.size(), options.stopped, [&](std::size_t i) {
    const MatchedWalk drawn =
        DrawMatchedWalk(site, settings.factors, options.duration_s, random.Fork(i + 1));
    at_truth[i] = StatisticsAtTruth(site, settings.factors, drawn);
    for (std::size_t m = 0; m < estimators.size(); ++m) {
      result.outcomes[m][i] = Measure(*estimators[m], site, drawn.evidence, drawn.truth, 0);
    }
    progress.Done(names[i]);
  });
  for (const auto& walk : at_truth) {
    for (const ResidualStatistics& s : walk) {
      result.at_truth[s.type].Add(s.count, s.dimension, s.mean_squared_whitened);
    }
  }
  return result;
}

std::vector<LoadedWalk> Load(const HonestyOptions& options, const Dataset& dataset,
                             const Building& building, const FrontendSettings& settings) {
  std::vector<LoadedWalk> walks(dataset.walks.size());
  ParallelFor(options.workers, walks.size(), options.stopped, [&](std::size_t i) {
    walks[i] = LoadWalk(dataset.walks[i], building, settings, options.floor_given);
  });
  return walks;
}

std::vector<const LoadedWalk*> Pointers(const std::vector<LoadedWalk>& walks) {
  std::vector<const LoadedWalk*> pointers;
  for (const LoadedWalk& walk : walks) {
    if (walk.error.empty()) {
      pointers.push_back(&walk);
    } else {
      std::fprintf(stderr, "walkgraph: %s\n", walk.error.c_str());
    }
  }
  return pointers;
}

HonestyResult MeasureRecorded(const HonestyOptions& options, const Dataset& train,
                              const Dataset& test) {
  const std::vector<ConfigOverride> overrides = Overrides(options);
  Settings settings;
  ApplyOverrides(overrides, &settings);
  const std::vector<LoadedWalk> training = Load(options, train, train.building, settings.frontend);
  const std::vector<LoadedWalk> tested = Load(options, test, train.building, settings.frontend);
  const std::vector<const LoadedWalk*> walks = Pointers(tested);
  std::vector<std::string> names;
  names.reserve(walks.size());
  for (const LoadedWalk* walk : walks) names.push_back(walk->file.id);
  HonestyResult result = EmptyResult(options, names);
  if (options.stopped()) return result;
  const Fold fold = PrepareFold(train.building, Pointers(training), walks, overrides,
                                ThreadedExecutor(options.workers));
  const auto estimators = MakeEstimators(options.methods, fold.settings);
  Progress progress(static_cast<int>(walks.size()), "walks", options.out + "/run/progress");
  ParallelFor(options.workers, walks.size(), options.stopped, [&](std::size_t i) {
    for (std::size_t m = 0; m < estimators.size(); ++m) {
      result.outcomes[m][i] = Measure(*estimators[m], fold.site, walks[i]->evidence,
                                      walks[i]->truth, settings.scoring.waypoint_sigma_m);
    }
    progress.Done(names[i]);
  });
  return result;
}

// Opens what has to be opened before the first file is written.
HonestyResult Measure(const HonestyOptions& options) {
  const auto prepare = [&] {
    PrepareResultFolder(options.out);
    LogToRunFolder(options.out + "/run");
    WriteRunDescription(options.out + "/run", options.command_line, options.workers);
  };
  if (options.test.empty()) {
    prepare();
    return MeasureDrawn(options);
  }
  const Dataset train = OpenDataset(options.train), test = OpenDataset(options.test);
  prepare();
  return MeasureRecorded(options, train, test);
}

bool AnyAnswer(const HonestyResult& result) {
  return std::any_of(result.outcomes.begin(), result.outcomes.end(), [](const auto& walks) {
    return std::any_of(walks.begin(), walks.end(),
                       [](const WalkHonesty& walk) { return walk.has_trajectory; });
  });
}

}  // namespace

int MeasureHonesty(const HonestyOptions& options) {
  const HonestyResult result = Measure(options);
  if (options.stopped()) return kExitInterrupted;
  WriteFileWhole(options.out + "/honesty.csv", FormatHonestyCsv(result));
  WriteFileWhole(options.out + "/honesty.json", FormatHonestyJson(result, options.command_line));
  const std::vector<Figure> figures = HonestyFigures(result);
  WriteFileWhole(options.out + "/honesty.html", FormatHonestyPage(figures));
  std::filesystem::create_directories(options.out + "/figures");
  for (const Figure& figure : figures) {
    WriteFileWhole(options.out + "/figures/" + figure.name + ".svg", figure.svg);
  }
  std::fputs(FormatHonesty(result).c_str(), stdout);
  return AnyAnswer(result) ? kExitOk : kExitNoTrajectory;
}

}  // namespace walkgraph
