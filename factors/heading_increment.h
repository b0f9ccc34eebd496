#ifndef WALKGRAPH_FACTORS_HEADING_INCREMENT_H_
#define WALKGRAPH_FACTORS_HEADING_INCREMENT_H_

#include <string_view>

#include "data/angle.h"
#include "factors/cost.h"

namespace walkgraph {

// The turn delta that the gyroscope saw between two nodes dt apart, with bias b:
//   r = wrap(h1 - h0 - (delta - b dt)) / sigma.
// Without a gyroscope delta and dt are zero and sigma is what a person may turn.
// Blocks: heading 0, heading 1, gyroscope bias.
struct HeadingIncrementFactor {
  static constexpr std::string_view kName = "heading_increment";
  static constexpr int kDimension = 1;
  using Blocks = BlockSizes<1, 1, 1>;

  double delta_rad = 0;
  double duration_s = 0;
  double sigma_rad = 1;

  template <typename T>
  bool operator()(const T* h0, const T* h1, const T* bias, T* residual) const {
    residual[0] = WrapAngle(T(h1[0] - h0[0] - delta_rad + bias[0] * duration_s)) / sigma_rad;
    return true;
  }

  bool Evaluate(const double* const* blocks, double* residual, double** jacobians) const {
    (*this)(blocks[0], blocks[1], blocks[2], residual);
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) jacobians[0][0] = -1.0 / sigma_rad;
    if (jacobians[1] != nullptr) jacobians[1][0] = 1.0 / sigma_rad;
    if (jacobians[2] != nullptr) jacobians[2][0] = duration_s / sigma_rad;
    return true;
  }

  // The second heading, unwrapped from the first.
  double Predict(double h0, double bias) const { return h0 + delta_rad - bias * duration_s; }

  double LogNormaliser() const { return GaussianLogNormaliser(sigma_rad); }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_HEADING_INCREMENT_H_
