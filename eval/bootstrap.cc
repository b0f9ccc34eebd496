#include "eval/bootstrap.h"

#include <algorithm>
#include <cstddef>

#include "eval/metrics.h"
#include "eval/random.h"

namespace walkgraph {

double PooledMean(const std::vector<WalkTotal>& walks) {
  double sum = 0;
  int n = 0;
  for (const WalkTotal& walk : walks) {
    sum += walk.sum;
    n += walk.n;
  }
  return n == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / n;
}

Interval BootstrapMean(const std::vector<WalkTotal>& walks) {
  // Walks without waypoints would only make empty resamples possible.
  std::vector<WalkTotal> scored;
  for (const WalkTotal& walk : walks) {
    if (walk.n > 0) scored.push_back(walk);
  }
  if (scored.size() < 2) return {};
  SplitMix64 random(kBootstrapSeed);
  std::vector<double> means;
  std::vector<WalkTotal> resample(scored.size());
  for (int i = 0; i < kBootstrapResamples; ++i) {
    for (WalkTotal& walk : resample) walk = scored[random.Index(scored.size())];
    means.push_back(PooledMean(resample));
  }
  std::sort(means.begin(), means.end());
  return {Quantile(means, 0.025), Quantile(means, 0.975)};
}

}  // namespace walkgraph
