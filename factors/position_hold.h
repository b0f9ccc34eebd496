#ifndef WALKGRAPH_FACTORS_POSITION_HOLD_H_
#define WALKGRAPH_FACTORS_POSITION_HOLD_H_

#include <Eigen/Core>
#include <string_view>

#include "factors/cost.h"

namespace walkgraph {

// The person stayed where they were, give or take sigma per axis:
//   r = (p1 - p0) / sigma.
// With the sigma of a standing person it holds the position; with that of unseen walking it is all
// that ties two nodes together where no step was detected.
// Blocks: position 0, position 1.
struct PositionHoldFactor {
  static constexpr std::string_view kName = "standing";
  static constexpr int kDimension = 2;
  using Blocks = BlockSizes<2, 2>;

  double sigma_m = 1;

  template <typename T>
  bool operator()(const T* p0, const T* p1, T* residual) const {
    residual[0] = (p1[0] - p0[0]) / sigma_m;
    residual[1] = (p1[1] - p0[1]) / sigma_m;
    return true;
  }

  Eigen::Vector2d Predict(const Eigen::Vector2d& p0) const { return p0; }

  double LogNormaliser() const { return 2.0 * GaussianLogNormaliser(sigma_m); }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_POSITION_HOLD_H_
