#ifndef WALKGRAPH_FACTORS_GAUSS_MARKOV_H_
#define WALKGRAPH_FACTORS_GAUSS_MARKOV_H_

#include <Eigen/Core>
#include <cmath>
#include <string_view>

#include "factors/cost.h"

namespace walkgraph {

// A stationary first-order Gauss-Markov (Ornstein-Uhlenbeck) process per axis, from one knot to the
// next, dt later, with stationary sigma s and correlation time tau: with rho = exp(-dt / tau),
//   r = (e1 - rho e0) / (s sqrt(1 - rho^2)).
// The first knot needs a prior of sigma s; then every knot has it.
// Blocks: map error 0, map error 1.
struct GaussMarkovFactor {
  static constexpr std::string_view kName = "map_error";
  static constexpr int kDimension = 2;
  using Blocks = BlockSizes<2, 2>;

  double rho = 0;
  double sigma_m = 1;  // s sqrt(1 - rho^2)

  static GaussMarkovFactor Stationary(double sigma_m, double correlation_s, double duration_s) {
    const double rho = std::exp(-duration_s / correlation_s);
    return {rho, sigma_m * std::sqrt(1.0 - rho * rho)};
  }

  template <typename T>
  bool operator()(const T* e0, const T* e1, T* residual) const {
    residual[0] = (e1[0] - e0[0] * rho) / sigma_m;
    residual[1] = (e1[1] - e0[1] * rho) / sigma_m;
    return true;
  }

  Eigen::Vector2d Predict(const Eigen::Vector2d& e0) const { return rho * e0; }

  double LogNormaliser() const { return 2.0 * GaussianLogNormaliser(sigma_m); }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_GAUSS_MARKOV_H_
