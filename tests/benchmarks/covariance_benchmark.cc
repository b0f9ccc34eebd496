// An hour of walking at two nodes a second: marginal covariances of every block.
#include <benchmark/benchmark.h>

#include "graph/marginal_covariance.h"
#include "graph/walk_problem.h"

namespace walkgraph {
namespace {

void Covariance(benchmark::State& state, const WalkOptions& options) {
  const WalkProblem walk = MakeWalk(options);
  for (auto iteration : state) {
    benchmark::DoNotOptimize(MarginalCovariance::Compute(walk.system));
  }
  state.counters["blocks"] = static_cast<double>(walk.system.block_sizes.size());
}

void CovarianceObservable(benchmark::State& state) {
  Covariance(state, {.nodes = static_cast<int>(state.range(0))});
}
BENCHMARK(CovarianceObservable)->Arg(100)->Arg(7200)->Unit(benchmark::kMillisecond);

void CovarianceWithoutPositions(benchmark::State& state) {
  Covariance(state,
             {.nodes = static_cast<int>(state.range(0)), .positions = false, .headings = false});
}
BENCHMARK(CovarianceWithoutPositions)->Arg(7200)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace walkgraph

BENCHMARK_MAIN();
