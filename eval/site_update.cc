#include "eval/site_update.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

#include "data/dataset.h"
#include "eval/evaluate.h"
#include "eval/loaded_walk.h"
#include "eval/methods.h"
#include "eval/parallel.h"
#include "eval/progress.h"
#include "eval/run_walk.h"
#include "frontends/radio_map/map_update.h"
#include "frontends/radio_map/reading_lag.h"
#include "frontends/radio_map/site_file.h"
#include "solvers/baselines/mufaf/site_update.h"

namespace walkgraph {
namespace {

// A walk and where the method thinks it went; no trajectory where it could not tell.
struct LocatedWalk {
  LoadedWalk walk;
  Evidence aligned;
  Trajectory trajectory;
};

std::vector<LocatedWalk> LoadAll(const SiteUpdateOptions& options, const Site& site,
                                 const Settings& settings) {
  const Dataset dataset = OpenDataset(options.learn.dataset);
  std::vector<LocatedWalk> walks(dataset.walks.size());
  ParallelFor(options.learn.workers, walks.size(), options.learn.stopped, [&](std::size_t i) {
    LocatedWalk& to = walks[i];
    to.walk = LoadWalk(dataset.walks[i], site.building, settings.frontend, options.floor_given);
    if (to.walk.error.empty()) to.aligned = AlignReadings(site, to.walk.evidence);
  });
  return walks;
}

void Locate(const SiteUpdateOptions& options, const Site& site, const Estimator& estimator,
            std::vector<LocatedWalk>* walks) {
  Progress progress(static_cast<int>(walks->size()), "walks located", "");
  ParallelFor(options.learn.workers, walks->size(), options.learn.stopped, [&](std::size_t i) {
    LocatedWalk& walk = (*walks)[i];
    walk.trajectory = Trajectory();
    if (walk.walk.error.empty()) {
      EstimateResult result = RunMethod(estimator, site, walk.aligned, Truth());
      if (result.status == EstimateStatus::kOk) walk.trajectory = std::move(result.trajectory);
    }
    progress.Done(walk.walk.file.id);
  });
}

// What the map learns from: raw readings, whose lag its trainer knows, or aligned ones.
std::vector<SurveyWalk> WalksToLearn(const std::vector<LocatedWalk>& located, bool aligned) {
  std::vector<SurveyWalk> walks;
  for (const LocatedWalk& walk : located) {
    walks.push_back(
        {aligned ? &walk.aligned : &walk.walk.evidence, walk.trajectory, walk.walk.file.trial});
  }
  return walks;
}

void PrintChanges(const Site& before, const Site& after, const std::vector<SurveyWalk>& walks,
                  const MapChangeSettings& settings) {
  std::printf("%zu transmitters, %zu of them new\n", after.transmitters.size(),
              after.transmitters.size() - before.transmitters.size());
  for (const RadioMap& map : before.maps) {
    int changed = 0, vanished = 0;
    for (const TransmitterChange& change : FindChanges(before, map, walks, settings)) {
      changed += change.changed() ? 1 : 0;
      vanished += change.vanished ? 1 : 0;
    }
    std::printf("floor %d %s: %d of %zu transmitters changed by over three sigma, %d vanished\n",
                map.floor, RadioName(map.radio), changed, map.fields.size(), vanished);
  }
}

}  // namespace

int UpdateSurveyedSite(const SiteUpdateOptions& options) {
  Settings settings;
  ApplyOverrides(options.learn.overrides, &settings);
  const Site site = ReadSiteFile(options.site);
  const bool graph = options.update == SiteUpdate::kGraph;
  const std::string own_method = graph ? "batch" : "viterbi";
  const std::unique_ptr<Estimator> estimator =
      ParseMethods(options.method.empty() ? own_method : options.method).front()->make(settings);
  std::vector<LocatedWalk> located = LoadAll(options, site, settings);
  Site updated = site;
  for (int round = 0; round < settings.map_change.rounds; ++round) {
    Locate(options, updated, *estimator, &located);
    if (options.learn.stopped()) return kExitInterrupted;
    const std::vector<SurveyWalk> walks = WalksToLearn(located, !graph);
    std::printf("%td of %zu walks located\n",
                std::count_if(walks.begin(), walks.end(),
                              [](const SurveyWalk& walk) { return !walk.trajectory.empty(); }),
                walks.size());
    if (graph) {
      updated = UpdateSite(site, walks, settings.radio_map, settings.map_change);
      PrintChanges(site, updated, walks, settings.map_change);
      continue;
    }
    settings.baselines.mufaf.update.interpolation = options.update == SiteUpdate::kKriging
                                                        ? MapInterpolation::kKriging
                                                        : MapInterpolation::kCovariance;
    CellUpdate update = UpdateSiteByCells(site, walks, settings.radio_map, settings.baselines.mufaf,
                                          settings.baselines.wknn);
    std::printf("%d of %d scans taken into the map, %d retired\n", update.taken, update.offered,
                update.retired);
    updated = std::move(update.site);
  }
  WriteSiteFile(updated, options.learn.out);
  return kExitOk;
}

}  // namespace walkgraph
