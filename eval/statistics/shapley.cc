#include "eval/statistics/shapley.h"

#include <bit>
#include <cstddef>

namespace walkgraph {

std::vector<double> ShapleyValues(const std::vector<double>& values, int players) {
  // Share of the orders in which exactly k others joined before: k! (n - 1 - k)! / n!.
  const auto n = static_cast<std::size_t>(players);
  std::vector<double> share(n);
  for (std::size_t k = 0; k < n; ++k) {
    share[k] = k == 0 ? 1.0 / static_cast<double>(n)
                      : share[k - 1] * static_cast<double>(k) / static_cast<double>(n - k);
  }
  std::vector<double> contribution(n, 0.0);
  for (std::size_t subset = 0; subset < values.size(); ++subset) {
    for (std::size_t player = 0; player < n; ++player) {
      const std::size_t bit = std::size_t{1} << player;
      if ((subset & bit) != 0) continue;
      const auto joined = static_cast<std::size_t>(std::popcount(subset));
      contribution[player] += share[joined] * (values[subset | bit] - values[subset]);
    }
  }
  return contribution;
}

}  // namespace walkgraph
