#include "eval/statistics/correlation.h"

#include <cmath>
#include <cstddef>
#include <numeric>

#include "eval/statistics/rank_test.h"

namespace walkgraph {
namespace {

double Mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double Pearson(const std::vector<double>& a, const std::vector<double>& b) {
  const double mean_a = Mean(a), mean_b = Mean(b);
  double aa = 0, ab = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  return ab / std::sqrt(aa * bb);
}

}  // namespace

Correlation Correlate(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!std::isfinite(a[i]) || !std::isfinite(b[i])) continue;
    x.push_back(a[i]);
    y.push_back(b[i]);
  }
  Correlation result;
  result.n = static_cast<int>(x.size());
  if (result.n < 2) return result;
  result.pearson = Pearson(x, y);
  result.spearman = Pearson(MidRanks(x), MidRanks(y));
  return result;
}

}  // namespace walkgraph
