#include "eval/smooth.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "data/dataset.h"
#include "data/input_error.h"
#include "eval/evaluate.h"
#include "eval/files.h"
#include "eval/loaded_walk.h"
#include "eval/parallel.h"
#include "eval/progress.h"
#include "eval/result_files.h"
#include "eval/run_folder.h"
#include "eval/run_walk.h"
#include "eval/summary.h"
#include "eval/usage_error.h"
#include "frontends/radio_map/site_file.h"

namespace walkgraph {
namespace {

// The walks of all recordings. One that is not recognised becomes a row with status input_error,
// unless there is no other. Throws InputError then, UsageError where two walks share an id.
std::vector<LoadedWalk> FindWalks(const std::vector<std::string>& paths) {
  std::vector<LoadedWalk> walks;
  std::optional<InputError> first_error;
  for (const std::string& path : paths) {
    try {
      for (const WalkFile& file : OpenDataset(path).walks) {
        walks.emplace_back();
        walks.back().file = file;
      }
    } catch (const InputError& error) {
      if (!first_error) first_error = error;
      walks.emplace_back();
      walks.back().file.id = std::filesystem::path(path).stem().string();
      walks.back().error = error.what();
    }
  }
  const auto broken = [](const LoadedWalk& walk) { return !walk.error.empty(); };
  if (first_error && std::all_of(walks.begin(), walks.end(), broken)) throw *first_error;
  std::set<std::string> ids;
  for (const LoadedWalk& walk : walks) {
    if (!ids.insert(walk.file.id).second) {
      throw UsageError("two recordings are called \"" + walk.file.id + "\", expected each once");
    }
  }
  return walks;
}

// The floors by name, for the table.
std::map<int, std::string> FloorNames(const Building& building) {
  std::map<int, std::string> names;
  for (const Floor& floor : building.floors) names[floor.number] = floor.name;
  return names;
}

}  // namespace

int SmoothRecordings(const SmoothOptions& options) {
  Settings settings;
  ApplyOverrides(options.overrides, &settings);
  const Site site = ReadSiteFile(options.site);
  std::vector<LoadedWalk> walks = FindWalks(options.recordings);
  PrepareResultFolder(options.out);
  LogToRunFolder(options.out + "/run");
  WriteRunDescription(options.out + "/run", options.command_line, options.workers);

  Evaluation evaluation;
  std::vector<std::unique_ptr<Estimator>> estimators;
  for (const Method* method : options.methods) {
    evaluation.methods.push_back(method->name);
    estimators.push_back(method->make(settings));
  }
  evaluation.walks.resize(walks.size());
  const WalkRunOptions run = {options.out, evaluation.methods, options.tum,
                              settings.scoring.waypoint_sigma_m};
  {
    Progress progress(static_cast<int>(walks.size()), "walks", options.out + "/run/progress");
    ParallelFor(options.workers, walks.size(), options.stopped, [&](std::size_t i) {
      LoadedWalk& walk = walks[i];
      if (walk.error.empty()) {
        walk = LoadWalk(walk.file, site.building, settings.frontend, options.floor_given);
      }
      if (options.anchor_every > 0) {
        UseWaypointsAsAnchors(options.anchor_every, settings.scoring.waypoint_sigma_m, &walk);
      }
      evaluation.walks[i] = RunWalk(run, site, estimators, walk, 0);
      progress.Done(walk.file.id);
    });
  }
  WriteFileWhole(options.out + "/scores.csv", FormatScoresCsv(evaluation));
  WriteFileWhole(options.out + "/building.json", FormatBuildingJson(site.building));
  WriteTimings(options.out + "/run", evaluation);
  const auto sections = SummariseEvaluation(evaluation, FloorNames(site.building));
  std::fputs(FormatSummary(sections, SecondsPerWalk(evaluation)).c_str(), stdout);
  if (options.stopped()) return kExitInterrupted;
  return AnyTrajectory(evaluation) ? kExitOk : kExitNoTrajectory;
}

}  // namespace walkgraph
