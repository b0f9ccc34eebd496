#ifndef WALKGRAPH_FACTORS_BAROMETRIC_H_
#define WALKGRAPH_FACTORS_BAROMETRIC_H_

#include <string_view>

#include "factors/cost.h"

namespace walkgraph {

// A height H by the barometer, which is off by weather, device and the site's altitude, together b:
//   r = (z + b - H) / sigma.
// Blocks: height, barometric offset.
struct BarometricFactor {
  static constexpr std::string_view kName = "barometric";
  static constexpr int kDimension = 1;
  using Blocks = BlockSizes<1, 1>;

  double height_m = 0;
  double sigma_m = 1;

  template <typename T>
  bool operator()(const T* z, const T* offset, T* residual) const {
    residual[0] = (z[0] + offset[0] - height_m) / sigma_m;
    return true;
  }

  // The offset that the measurement implies for a height.
  double Predict(double z) const { return height_m - z; }

  double LogNormaliser() const { return GaussianLogNormaliser(sigma_m); }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_BAROMETRIC_H_
