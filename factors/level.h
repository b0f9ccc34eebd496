#ifndef WALKGRAPH_FACTORS_LEVEL_H_
#define WALKGRAPH_FACTORS_LEVEL_H_

#include <string_view>

#include "factors/cost.h"

namespace walkgraph {

// A person on a level is at its height h, give or take ramps and uneven ground: r = (z - h) /
// sigma. Block: height.
struct LevelFactor {
  static constexpr std::string_view kName = "level";
  static constexpr int kDimension = 1;
  using Blocks = BlockSizes<1>;

  double height_m = 0;
  double sigma_m = 1;

  template <typename T>
  bool operator()(const T* z, T* residual) const {
    residual[0] = (z[0] - height_m) / sigma_m;
    return true;
  }

  double LogNormaliser() const { return GaussianLogNormaliser(sigma_m); }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_LEVEL_H_
