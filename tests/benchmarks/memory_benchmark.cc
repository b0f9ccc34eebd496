// Half a minute of walking on a site of 2,500 transmitters, in a process that does nothing else:
// time, and the most memory that the process ever held.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "benchmarks/fresh_thread.h"
#include "benchmarks/large_site.h"
#include "solvers/batch_smoother.h"
#include "solvers/window_smoother.h"

namespace walkgraph {
namespace {

double PeakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // Linux counts in KiB
}

void Smooth(benchmark::State& state, const Estimator& estimator) {
  LargeSite large(2500);
  const Evidence evidence = large.Walk();
  for (auto _ : state) {
    OnFreshThread([&] { benchmark::DoNotOptimize(estimator.Estimate(large.site, evidence)); });
  }
  state.counters["readings"] = static_cast<double>(evidence.readings.size());
  state.counters["peak_mb"] = PeakMegabytes();
}

void BM_LargeSiteBatch(benchmark::State& state) { Smooth(state, BatchSmoother({}, {})); }
BENCHMARK(BM_LargeSiteBatch)->UseRealTime()->Unit(benchmark::kMillisecond);
void BM_LargeSiteWindow(benchmark::State& state) { Smooth(state, WindowSmoother({}, {}, {})); }
BENCHMARK(BM_LargeSiteWindow)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace walkgraph

BENCHMARK_MAIN();
