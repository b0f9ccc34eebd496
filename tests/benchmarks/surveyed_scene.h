#ifndef WALKGRAPH_TESTS_BENCHMARKS_SURVEYED_SCENE_H_
#define WALKGRAPH_TESTS_BENCHMARKS_SURVEYED_SCENE_H_

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "data/dataset.h"
#include "eval/fold.h"
#include "eval/loaded_walk.h"

namespace walkgraph {

// A calibrated site and a walk that is not in it.
struct SurveyedScene {
  Site site;
  Settings settings;
  LoadedWalk walk;

  double WalkSeconds() const {
    return SecondsBetween(walk.evidence.begin_ns, walk.evidence.end_ns);
  }
};

inline std::vector<LoadedWalk> LoadAll(const Dataset& dataset, const Building& building) {
  std::vector<LoadedWalk> walks;
  for (const WalkFile& file : dataset.walks) walks.push_back(LoadWalk(file, building, {}, true));
  return walks;
}

inline SurveyedScene MakeScene(const Building& building, const std::vector<LoadedWalk>& walks,
                               const LoadedWalk& walk) {
  std::vector<const LoadedWalk*> training;
  for (const LoadedWalk& other : walks) {
    if (&other != &walk) training.push_back(&other);
  }
  Fold fold = PrepareFold(building, training, {&walk}, {});
  return {std::move(fold.site), fold.settings, walk};
}

// The committed sample: its survey, and the first of its test walks.
inline const SurveyedScene* SampleScene() {
  static const SurveyedScene* const kScene = [] {
    const std::string folder = std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples";
    const Dataset survey = OpenDataset(folder + "/survey");
    const Dataset test = OpenDataset(folder + "/test");
    const LoadedWalk walk = LoadWalk(test.walks.front(), survey.building, {}, true);
    return new SurveyedScene(MakeScene(survey.building, LoadAll(survey, survey.building), walk));
  }();
  return kScene;
}

struct RecordedFloor {
  Building building;
  std::vector<LoadedWalk> walks;
};

// A recorded floor of the mall; nothing where WALKGRAPH_REAL_DATA does not lead to it.
inline std::optional<RecordedFloor> ReadFloor(const std::string& name) {
  const char* root = std::getenv("WALKGRAPH_REAL_DATA");
  const std::string folder = root == nullptr ? "" : std::string(root) + "/ilc20/data/site1/" + name;
  if (!std::filesystem::is_directory(folder)) return std::nullopt;
  const Dataset dataset = OpenDataset(folder);
  return RecordedFloor{dataset.building, LoadAll(dataset, dataset.building)};
}

// Floor F2 without its walk that is closest to half a minute long, and that walk; nullptr where
// there is no floor.
inline const SurveyedScene* RecordedScene() {
  static const SurveyedScene* const kScene = []() -> const SurveyedScene* {
    const std::optional<RecordedFloor> floor = ReadFloor("F2");
    if (!floor) return nullptr;
    const LoadedWalk* best = nullptr;
    double best_s = std::numeric_limits<double>::infinity();
    for (const LoadedWalk& walk : floor->walks) {
      const double off_s =
          std::abs(SecondsBetween(walk.evidence.begin_ns, walk.evidence.end_ns) - 30);
      if (walk.evidence.readings.empty() || off_s >= best_s) continue;
      best = &walk;
      best_s = off_s;
    }
    return new SurveyedScene(MakeScene(floor->building, floor->walks, *best));
  }();
  return kScene;
}

using SceneSource = const SurveyedScene* (*)();

// As it is; where it is nullptr, after the benchmark has been told to skip.
template <typename Recordings>
const Recordings* OrSkip(benchmark::State& state, const Recordings* recordings) {
  if (recordings == nullptr) state.SkipWithError("WALKGRAPH_REAL_DATA does not lead to ilc20");
  return recordings;
}

}  // namespace walkgraph

#endif  // WALKGRAPH_TESTS_BENCHMARKS_SURVEYED_SCENE_H_
