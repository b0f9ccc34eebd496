#ifndef WALKGRAPH_EVAL_HONESTY_RANDOM_FIELD_H_
#define WALKGRAPH_EVAL_HONESTY_RANDOM_FIELD_H_

#include <Eigen/Core>
#include <array>

#include "data/simulator/random.h"

namespace walkgraph {

// A stationary Gaussian field over the plane, of mean zero and variance one, by random Fourier
// features (Rahimi and Recht, NIPS 2007): a sum of cosines whose wave vectors are drawn from the
// spectrum that belongs to the covariance.
class RandomField {
 public:
  // Covariance exp(-d^2 / (2 length^2)): smooth.
  static RandomField SquaredExponential(double length_m, Random random);
  // Covariance exp(-d / length): what a walker at constant speed meets as a first-order
  // Gauss-Markov process.
  static RandomField Exponential(double length_m, Random random);

  double At(const Eigen::Vector2d& position_m) const;

 private:
  struct Wave {
    Eigen::Vector2d vector = Eigen::Vector2d::Zero();  // rad/m
    double phase_rad = 0;
  };
  std::array<Wave, 64> waves_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_HONESTY_RANDOM_FIELD_H_
