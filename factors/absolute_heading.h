#ifndef WALKGRAPH_FACTORS_ABSOLUTE_HEADING_H_
#define WALKGRAPH_FACTORS_ABSOLUTE_HEADING_H_

#include <string_view>

#include "data/angle.h"
#include "factors/cost.h"

namespace walkgraph {

// An absolute heading a, already turned into the building frame, against the direction of walking h
// with the slow offset o between them (how the phone is held, and the compass's own error):
//   r = wrap(h - a - o) / sigma.
// Blocks: heading, heading offset.
struct AbsoluteHeadingFactor {
  static constexpr std::string_view kName = "absolute_heading";
  static constexpr int kDimension = 1;
  using Blocks = BlockSizes<1, 1>;

  double heading_rad = 0;
  double sigma_rad = 1;

  template <typename T>
  bool operator()(const T* heading, const T* offset, T* residual) const {
    residual[0] = WrapAngle(T(heading[0] - heading_rad - offset[0])) / sigma_rad;
    return true;
  }

  double LogNormaliser() const { return GaussianLogNormaliser(sigma_rad); }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_ABSOLUTE_HEADING_H_
