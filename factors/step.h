#ifndef WALKGRAPH_FACTORS_STEP_H_
#define WALKGRAPH_FACTORS_STEP_H_

#include <Eigen/Core>
#include <cmath>
#include <string_view>

#include "data/angle.h"
#include "factors/cost.h"

namespace walkgraph {

// A step, or the part of one between two nodes, of modelled length L: with psi the mean of both
// headings, k the step scale and d = p1 - p0,
//   r = [ ( cos psi d_x + sin psi d_y - k L) / sigma_along
//         (-sin psi d_x + cos psi d_y) / sigma_across ].
// Blocks: position 0, heading 0, position 1, heading 1, step scale.
struct StepFactor {
  static constexpr std::string_view kName = "step";
  static constexpr int kDimension = 2;
  using Blocks = BlockSizes<2, 1, 2, 1, 1>;

  double length_m = 0;
  double sigma_along_m = 1;
  double sigma_across_m = 1;

  template <typename T>
  bool operator()(const T* p0, const T* h0, const T* p1, const T* h1, const T* scale,
                  T* residual) const {
    using std::cos;
    using std::sin;
    const T heading = (h0[0] + h1[0]) * 0.5;
    const T c = cos(heading), s = sin(heading);
    const T dx = p1[0] - p0[0], dy = p1[1] - p0[1];
    residual[0] = (c * dx + s * dy - scale[0] * length_m) / sigma_along_m;
    residual[1] = (c * dy - s * dx) / sigma_across_m;
    return true;
  }

  bool Evaluate(const double* const* blocks, double* residual, double** jacobians) const {
    const double heading = 0.5 * (blocks[1][0] + blocks[3][0]);
    const double c = std::cos(heading), s = std::sin(heading);
    const double dx = blocks[2][0] - blocks[0][0], dy = blocks[2][1] - blocks[0][1];
    const double forward = c * dx + s * dy, left = c * dy - s * dx;
    residual[0] = (forward - blocks[4][0] * length_m) / sigma_along_m;
    residual[1] = left / sigma_across_m;
    if (jacobians == nullptr) return true;
    const double ca = c / sigma_along_m, sa = s / sigma_along_m;
    const double cc = c / sigma_across_m, sc = s / sigma_across_m;
    Fill(jacobians[0], {-ca, -sa, sc, -cc});
    Fill(jacobians[2], {ca, sa, -sc, cc});
    for (const int heading_block : {1, 3}) {
      Fill(jacobians[heading_block], {0.5 * left / sigma_along_m, -0.5 * forward / sigma_across_m});
    }
    Fill(jacobians[4], {-length_m / sigma_along_m, 0.0});
    return true;
  }

  // Where the step ends.
  Eigen::Vector2d Predict(const Eigen::Vector2d& p0, double h0, double h1, double scale) const {
    const double heading = 0.5 * (h0 + h1);
    return p0 + scale * length_m * DirectionOf(heading);
  }

  double LogNormaliser() const {
    return GaussianLogNormaliser(sigma_along_m) + GaussianLogNormaliser(sigma_across_m);
  }

 private:
  static void Fill(double* jacobian, std::initializer_list<double> values) {
    if (jacobian != nullptr) std::copy(values.begin(), values.end(), jacobian);
  }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_STEP_H_
