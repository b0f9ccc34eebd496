#include "eval/survey.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <string>

#include "data/dataset.h"
#include "data/input_error.h"
#include "eval/evaluate.h"
#include "eval/files.h"
#include "eval/fold.h"
#include "eval/loaded_walk.h"
#include "eval/parallel.h"
#include "eval/progress.h"
#include "eval/survey_placement.h"
#include "frontends/radio_map/device_offsets.h"
#include "frontends/radio_map/site_file.h"

namespace walkgraph {
namespace {

// Reads all walks; empty where the run was stopped.
std::vector<LoadedWalk> LoadWalks(const LearnOptions& options, const Dataset& dataset) {
  Settings settings;
  ApplyOverrides(options.overrides, &settings);
  std::vector<LoadedWalk> walks(dataset.walks.size());
  Progress progress(static_cast<int>(walks.size()), "walks read", "");
  ParallelFor(options.workers, walks.size(), options.stopped, [&](std::size_t i) {
    walks[i] = LoadWalk(dataset.walks[i], dataset.building, settings.frontend, true);
    progress.Done(dataset.walks[i].id);
  });
  if (options.stopped()) walks.clear();
  return walks;
}

std::vector<const LoadedWalk*> WalksWithTruth(const LearnOptions& options,
                                              const std::vector<LoadedWalk>& walks) {
  std::vector<const LoadedWalk*> with_truth;
  for (const LoadedWalk& walk : walks) {
    if (!walk.error.empty()) std::fprintf(stderr, "walkgraph: %s\n", walk.error.c_str());
    if (!walk.truth.waypoints.empty()) with_truth.push_back(&walk);
  }
  if (with_truth.empty()) {
    throw InputError(options.dataset, 0, "no walk has waypoints", "walks with ground truth");
  }
  return with_truth;
}

// How good the survey's positions are, both ways, by waypoints that neither was told of.
std::string CompareSurveyPositions(const LearnOptions& options, const Building& building,
                                   const std::vector<const LoadedWalk*>& walks, Settings settings) {
  std::vector<LeftOutRow> rows = {{"walked_distance", {}}, {"smoother", {}}};
  for (const SurveyPositions positions :
       {SurveyPositions::kWalkedDistance, SurveyPositions::kSmoother}) {
    settings.survey.positions = positions;
    std::vector<std::vector<WaypointError>> errors(walks.size());
    ParallelFor(options.workers, walks.size(), options.stopped, [&](std::size_t i) {
      errors[i] = LeftOutErrors(building, walks[i]->truth, walks[i]->evidence, settings);
    });
    std::vector<WaypointError>& all = rows[static_cast<std::size_t>(positions)].errors;
    for (const auto& of_walk : errors) all.insert(all.end(), of_walk.begin(), of_walk.end());
  }
  return FormatLeftOut(rows);
}

// A line of text as printf would have it.
template <typename... Values>
std::string Line(const char* format, Values... values) {
  std::array<char, 160> line;
  std::snprintf(line.data(), line.size(), format, values...);
  return line.data();
}

// What was calibrated with the maps and lies in the site, as comments.
std::string CalibrationOfSite(const Site& site, const TrainerSettings& settings) {
  std::string text;
  for (const RadioMap& map : site.maps) {
    text += Line(
        "# In the site, floor %d %s: n_eff %.3g, map error %.3g m, and %.3g m more per metre "
        "from the survey\n",
        map.floor, RadioName(map.radio), map.n_eff, map.map_error_sigma_m, map.map_error_growth);
  }
  for (const MagneticMap& map : site.magnetic_maps) {
    text += Line("# In the site, floor %d magnetic: correlation %.3g s, map error %.3g m\n",
                 map.floor, map.correlation_s, map.map_error_sigma_m);
  }
  for (const Radio radio : kAllRadios) {
    const auto map = std::find_if(site.maps.begin(), site.maps.end(),
                                  [radio](const RadioMap& m) { return m.radio == radio; });
    if (map == site.maps.end()) continue;
    text += Line(
        "# In the site, %s readings lag by %.2f s, the body shadows them by %.2f dB, and "
        "walks hear %.1f dB apart\n",
        RadioName(radio), site.reading_lag_s[static_cast<std::size_t>(radio)], map->body_shadow_db,
        EstimateDeviceOffsets(site.scans, radio, settings.sample_spacing_m).spread_db);
  }
  for (const DeviceLoudness& phone : site.loudness) {
    text += "# In the site, what to expect of " +
            (phone.device.empty() ? std::string("a phone without a name") : phone.device);
    text += Line(": %s %+.1f dB, give or take %.1f\n", RadioName(phone.radio), phone.mean_db,
                 phone.sigma_db);
  }
  return text;
}

}  // namespace

int SurveyDataset(const LearnOptions& options) {
  const Dataset dataset = OpenDataset(options.dataset);
  const std::vector<LoadedWalk> walks = LoadWalks(options, dataset);
  if (options.stopped()) return kExitInterrupted;
  const std::vector<const LoadedWalk*> training = WalksWithTruth(options, walks);
  std::fprintf(stderr, "training on %zu walks\n", training.size());
  const Fold fold = PrepareFold(dataset.building, training, {}, options.overrides,
                                ThreadedExecutor(options.workers));
  const Site& site = fold.site;
  if (options.stopped()) return kExitInterrupted;
  WriteSiteFile(site, options.out);
  std::printf("%s: %zu transmitters, %zu maps, %zu scans\n", options.out.c_str(),
              site.transmitters.size(), site.maps.size(), site.scans.size());
  const std::string positions =
      CompareSurveyPositions(options, dataset.building, training, fold.settings);
  if (options.stopped()) return kExitInterrupted;
  std::fputs(positions.c_str(), stdout);
  return kExitOk;
}

int CalibrateDataset(const LearnOptions& options) {
  const Dataset dataset = OpenDataset(options.dataset);
  const std::vector<LoadedWalk> walks = LoadWalks(options, dataset);
  if (options.stopped()) return kExitInterrupted;
  const std::vector<const LoadedWalk*> training = WalksWithTruth(options, walks);
  const Fold fold = PrepareFold(dataset.building, training, {}, options.overrides,
                                ThreadedExecutor(options.workers));
  if (options.stopped()) return kExitInterrupted;
  std::string text = "# Calibrated on " + std::to_string(training.size()) + " walks.\n" +
                     CalibrationOfSite(fold.site, fold.settings.radio_map);
  text += PrintChanges(Settings(), fold.settings);
  WriteFileWhole(options.out, text);
  std::fputs(text.c_str(), stdout);
  return kExitOk;
}

}  // namespace walkgraph
