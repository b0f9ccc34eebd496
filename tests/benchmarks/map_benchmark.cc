// Queries of a radio map of 2,500 transmitters: one field at one place, and one walk's scans at
// every place of a floor.
#include <benchmark/benchmark.h>

#include "benchmarks/large_site.h"
#include "factors/map_sweeps.h"
#include "solvers/baselines/likelihood_grid.h"

namespace walkgraph {
namespace {

LargeSite& Large() {
  static LargeSite large(2500);
  return large;
}

// All fields at a place that moves on; the basis is shared as a scan shares it.
template <FieldValue (RadioMap::*query)(int, const FieldBasis&) const>
void AllFields(benchmark::State& state) {
  const RadioMap& map = Large().site.maps.front();
  const auto fields = static_cast<int>(map.fields.size());
  double x = 0;
  for (auto _ : state) {
    x = std::fmod(x + 1.7, LargeSite::kWidthM);
    const FieldBasis basis = EvaluateBasis(map.grid, {x, 70});
    for (int field = 0; field < fields; ++field) {
      benchmark::DoNotOptimize((map.*query)(field, basis));
    }
  }
  state.SetItemsProcessed(state.iterations() * fields);
}
void BM_MapEvaluateWithGradients(benchmark::State& state) { AllFields<&RadioMap::Evaluate>(state); }
BENCHMARK(BM_MapEvaluateWithGradients)->Unit(benchmark::kMicrosecond);
void BM_MapEvaluateValue(benchmark::State& state) { AllFields<&RadioMap::EvaluateValue>(state); }
BENCHMARK(BM_MapEvaluateValue)->Unit(benchmark::kMicrosecond);

// The ten scans of half a minute on a lattice of one point per 4 m^2.
void BM_LikelihoodGrid(benchmark::State& state) {
  const RadioMap& map = Large().site.maps.front();
  const std::vector<MapSweep> sweeps =
      CollectMapSweeps(Large().site, map, Large().Walk(), FingerprintSettings{});
  std::vector<Eigen::Vector2d> positions;
  for (double x = 1; x < LargeSite::kWidthM; x += 2) {
    for (double y = 1; y < LargeSite::kHeightM; y += 2) positions.emplace_back(x, y);
  }
  for (auto _ : state) {
    const LikelihoodGrid grid(map, positions, {0, 3.0});
    benchmark::DoNotOptimize(grid.Evaluate(sweeps));
  }
  double readings = 0;
  for (const MapSweep& sweep : sweeps) readings += static_cast<double>(sweep.readings.size());
  state.counters["positions"] = static_cast<double>(positions.size());
  state.counters["readings"] = readings;
}
BENCHMARK(BM_LikelihoodGrid)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace walkgraph

BENCHMARK_MAIN();
