// A floor's survey walks from read recordings to a calibrated site: positions, maps, noise.
#include <benchmark/benchmark.h>

#include "benchmarks/surveyed_scene.h"
#include "eval/parallel.h"

namespace walkgraph {
namespace {

void BM_TrainFloor(benchmark::State& state, const char* name) {
  const std::optional<RecordedFloor> floor = ReadFloor(name);
  if (OrSkip(state, floor ? &*floor : nullptr) == nullptr) return;
  std::vector<const LoadedWalk*> training;
  for (const LoadedWalk& walk : floor->walks) training.push_back(&walk);
  const Executor run = ThreadedExecutor(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(PrepareFold(floor->building, training, {}, {}, run));
  }
  state.counters["walks"] = static_cast<double>(training.size());
}
BENCHMARK_CAPTURE(BM_TrainFloor, F1, "F1")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_TrainFloor, F2, "F2")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace walkgraph

BENCHMARK_MAIN();
