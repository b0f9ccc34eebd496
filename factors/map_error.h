#ifndef WALKGRAPH_FACTORS_MAP_ERROR_H_
#define WALKGRAPH_FACTORS_MAP_ERROR_H_

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <tuple>

#include "factors/cost.h"

namespace walkgraph {

// How alike a map's error is at two places and times: per axis
//   cov(e1, e2) = s^2 exp(-d / L - dt / tau).
// It belongs to the place, and fades with time only as far as the person, who carries the phone and
// stands in its way, turns and others pass.
struct MapErrorKernel {
  double sigma_m = 1;        // s
  double correlation_m = 1;  // L
  double correlation_s = 1;  // tau

  double Correlation(double distance_m, double seconds) const {
    return std::exp(-distance_m / correlation_m - std::abs(seconds) / correlation_s);
  }
};

// A map's error at a knot given that at kGiven others, per axis:
//   r = (e - sum_i w_i e_i) / sigma,
// sigma being what is left of the kernel's s; without others the stationary prior.
// Blocks: the given map errors, then that of the knot.
template <int kGiven>
struct MapErrorFactor {
  static constexpr std::string_view kName = "map_error";
  static constexpr int kDimension = 2;

  std::array<double, static_cast<std::size_t>(kGiven)> weight{};
  double sigma_m = 1;

  template <std::size_t... kIndex>
  static auto MakeBlocks(std::index_sequence<kIndex...>) -> BlockSizes<(void(kIndex), 2)...>;
  using Blocks = decltype(MakeBlocks(std::make_index_sequence<kGiven + 1>()));

  // The blocks' pointers, then the residual's.
  template <typename... Pointers>
  bool operator()(Pointers... pointers) const {
    return FillResidual(std::make_tuple(pointers...), std::make_index_sequence<kGiven>());
  }

  double LogNormaliser() const { return 2.0 * GaussianLogNormaliser(sigma_m); }

 private:
  template <typename Tuple, std::size_t... kIndex>
  bool FillResidual(const Tuple& pointers, std::index_sequence<kIndex...>) const {
    const auto* own = std::get<kGiven>(pointers);
    auto* residual = std::get<kGiven + 1>(pointers);
    for (int axis = 0; axis < 2; ++axis) {
      residual[axis] = own[axis];
      ((residual[axis] -= weight[kIndex] * std::get<kIndex>(pointers)[axis]), ...);
      residual[axis] /= sigma_m;
    }
    return true;
  }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_MAP_ERROR_H_
