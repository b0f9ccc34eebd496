// The graph at work on the sample and, with WALKGRAPH_REAL_DATA set, on a recorded floor: a window
// update, a batch solve, and the whole way from a file to a trajectory with the site loaded.
#include <benchmark/benchmark.h>

#include "benchmarks/fresh_thread.h"
#include "benchmarks/surveyed_scene.h"
#include "graph/walk_graph.h"
#include "solvers/batch_smoother.h"
#include "solvers/evidence_order.h"
#include "solvers/initial_trajectory.h"
#include "solvers/modes.h"
#include "solvers/window_run.h"

namespace walkgraph {
namespace {

void BM_WindowUpdate(benchmark::State& state, SceneSource source) {
  const SurveyedScene* scene = OrSkip(state, source());
  if (scene == nullptr) return;
  const Evidence evidence = InCanonicalOrder(scene->walk.evidence);
  const Settings& settings = scene->settings;
  double nodes = 0;
  for (auto _ : state) {
    OnFreshThread([&] {
      WindowRun run(scene->site, evidence, settings.factors, settings.solver, settings.window,
                    *evidence.floor);
      run.Play();
      nodes = static_cast<double>(run.walk().node_ns.size());
    });
  }
  state.counters["walk_s"] = scene->WalkSeconds();
  state.counters["s_per_update"] = benchmark::Counter(
      nodes, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(BM_WindowUpdate, sample, SampleScene)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_WindowUpdate, recorded, RecordedScene)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// From the best start to the minimum, without proposals and covariance.
void BM_BatchSolve(benchmark::State& state, SceneSource source) {
  const SurveyedScene* scene = OrSkip(state, source());
  if (scene == nullptr) return;
  const Evidence evidence = InCanonicalOrder(scene->walk.evidence);
  const Settings& settings = scene->settings;
  WalkGraph walk = BuildWalkGraph(scene->site, evidence, settings.factors, *evidence.floor);
  const InitialTrajectory start = ProposeTrajectories(scene->site, evidence, settings.factors,
                                                      *evidence.floor, settings.solver.hypotheses)
                                      .front();
  const GraphPart whole = WholeGraph(walk.graph);
  int failed_solves = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(SolveFrom(start, whole, settings.solver, &walk, &failed_solves));
  }
  state.counters["nodes"] = static_cast<double>(walk.node_ns.size());
  state.counters["factors"] = static_cast<double>(walk.graph.factors().size());
}
BENCHMARK_CAPTURE(BM_BatchSolve, sample, SampleScene)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_BatchSolve, recorded, RecordedScene)->Unit(benchmark::kMillisecond);

// Reading, evidence, proposals, every solve, covariance.
void BM_FileToTrajectory(benchmark::State& state, SceneSource source) {
  const SurveyedScene* scene = OrSkip(state, source());
  if (scene == nullptr) return;
  const Settings& settings = scene->settings;
  const BatchSmoother batch(settings.factors, settings.solver);
  for (auto _ : state) {
    OnFreshThread([&] {
      const LoadedWalk walk =
          LoadWalk(scene->walk.file, scene->site.building, settings.frontend, true);
      benchmark::DoNotOptimize(batch.Estimate(scene->site, walk.evidence));
    });
  }
  state.counters["walk_s"] = scene->WalkSeconds();
}
BENCHMARK_CAPTURE(BM_FileToTrajectory, sample, SampleScene)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_FileToTrajectory, recorded, RecordedScene)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace walkgraph

BENCHMARK_MAIN();
