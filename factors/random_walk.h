#ifndef WALKGRAPH_FACTORS_RANDOM_WALK_H_
#define WALKGRAPH_FACTORS_RANDOM_WALK_H_

#include <cmath>
#include <string_view>

#include "factors/cost.h"

namespace walkgraph {

// A scalar slow state from one knot to the next, dt later, with rate q (state unit per sqrt(s)):
//   r = (b1 - b0) / (q sqrt(dt)).
// Blocks: knot 0, knot 1.
struct RandomWalkFactor {
  static constexpr std::string_view kName = "random_walk";
  static constexpr int kDimension = 1;
  using Blocks = BlockSizes<1, 1>;

  double sigma = 1;  // q sqrt(dt)

  static RandomWalkFactor FromRate(double rate_per_sqrt_s, double duration_s) {
    return {rate_per_sqrt_s * std::sqrt(duration_s)};
  }

  template <typename T>
  bool operator()(const T* b0, const T* b1, T* residual) const {
    residual[0] = (b1[0] - b0[0]) / sigma;
    return true;
  }

  double Predict(double b0) const { return b0; }

  double LogNormaliser() const { return GaussianLogNormaliser(sigma); }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_RANDOM_WALK_H_
