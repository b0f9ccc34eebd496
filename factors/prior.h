#ifndef WALKGRAPH_FACTORS_PRIOR_H_
#define WALKGRAPH_FACTORS_PRIOR_H_

#include <string_view>

#include "factors/cost.h"

namespace walkgraph {

// What is known about a slow state before the walk: r = (b - mean) / sigma.
// Block: a scalar slow state.
struct StatePriorFactor {
  static constexpr std::string_view kName = "state_prior";
  static constexpr int kDimension = 1;
  using Blocks = BlockSizes<1>;

  double mean = 0;
  double sigma = 1;

  template <typename T>
  bool operator()(const T* state, T* residual) const {
    residual[0] = (state[0] - mean) / sigma;
    return true;
  }

  double LogNormaliser() const { return GaussianLogNormaliser(sigma); }
};

// A position known to sigma per axis: a surveyed tag that the person passed, or the prior of a
// walk's start about the middle of the floor. r = (p - mean) / sigma.
// Block: a position (or the map error, whose mean is zero).
struct PositionAnchorFactor {
  static constexpr std::string_view kName = "position_anchor";
  static constexpr int kDimension = 2;
  using Blocks = BlockSizes<2>;

  double x_m = 0, y_m = 0;
  double sigma_m = 1;

  template <typename T>
  bool operator()(const T* position, T* residual) const {
    residual[0] = (position[0] - x_m) / sigma_m;
    residual[1] = (position[1] - y_m) / sigma_m;
    return true;
  }

  double LogNormaliser() const { return 2.0 * GaussianLogNormaliser(sigma_m); }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_PRIOR_H_
