// The published systems' filters on the sample and, with WALKGRAPH_REAL_DATA set, on a recorded
// walk; and the time of an update alone, without the Wi-Fi fix that all of them share.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <memory>

#include "benchmarks/surveyed_scene.h"
#include "eval/methods.h"
#include "solvers/baselines/ahf/filters.h"
#include "solvers/baselines/way_graph.h"

namespace walkgraph {
namespace {

void BM_Method(benchmark::State& state, SceneSource source, const char* name) {
  const SurveyedScene* scene = OrSkip(state, source());
  if (scene == nullptr) return;
  const std::unique_ptr<Estimator> method = ParseMethods(name)[0]->make(scene->settings);
  for (auto _ : state) {
    benchmark::DoNotOptimize(method->Estimate(scene->site, scene->walk.evidence));
  }
  state.counters["walk_s"] = scene->WalkSeconds();
}
#define WALKGRAPH_BENCHMARK_METHOD(name)                                                          \
  BENCHMARK_CAPTURE(BM_Method, sample / name, SampleScene, #name)->Unit(benchmark::kMillisecond); \
  BENCHMARK_CAPTURE(BM_Method, recorded / name, RecordedScene, #name)->Unit(benchmark::kMillisecond)
WALKGRAPH_BENCHMARK_METHOD(tcpf);
WALKGRAPH_BENCHMARK_METHOD(tcpf_cross_assistive);
WALKGRAPH_BENCHMARK_METHOD(ahf);
WALKGRAPH_BENCHMARK_METHOD(ahf_particle_10000);

RatedFix FixAt(const SurveyedScene& scene, int k) {
  RatedFix rated;
  const std::vector<SurveyPoint>& path = scene.site.path;
  rated.fix.position_m = path[static_cast<std::size_t>(2 * k) % path.size()].position_m;
  rated.error_m = 4 + 2 * std::sin(k);
  return rated;
}

// Fixes that go along the survey's own paths, 2 m in 2 s.
void Update(benchmark::State& state, const SurveyedScene& scene, PositionFilter* filter) {
  int k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(filter->Advance(FixAt(scene, k++), 2.0));
}

void BM_AhfUpdate(benchmark::State& state, SceneSource source) {
  const SurveyedScene* scene = OrSkip(state, source());
  if (scene == nullptr) return;
  const AhfSettings settings;
  const int floor = scene->site.path.front().floor;
  const WayGraph ways(FindWays(scene->site, floor, settings.merge_m, settings.straight_rad));
  const auto filter = MakeAhfFilter(AhfPrediction::kWays, AhfWeights::kDynamic, &ways, settings);
  Update(state, *scene, filter.get());
  state.counters["links"] = static_cast<double>(ways.link_count());
}
BENCHMARK_CAPTURE(BM_AhfUpdate, sample, SampleScene)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_AhfUpdate, recorded, RecordedScene)->Unit(benchmark::kMicrosecond);

void BM_KalmanUpdate(benchmark::State& state) {
  const auto filter =
      MakeAhfFilter(AhfPrediction::kStraight, AhfWeights::kKalman, nullptr, AhfSettings());
  Update(state, *SampleScene(), filter.get());
}
BENCHMARK(BM_KalmanUpdate)->Unit(benchmark::kMicrosecond);

void BM_ParticleUpdate(benchmark::State& state) {
  const auto filter =
      MakeParticleFilter(static_cast<int>(state.range(0)), AhfWeights::kKalman, AhfSettings());
  Update(state, *SampleScene(), filter.get());
}
BENCHMARK(BM_ParticleUpdate)->Arg(1'000)->Arg(5'000)->Arg(10'000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace walkgraph

BENCHMARK_MAIN();
