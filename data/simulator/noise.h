#ifndef WALKGRAPH_DATA_SIMULATOR_NOISE_H_
#define WALKGRAPH_DATA_SIMULATOR_NOISE_H_

#include <Eigen/Core>
#include <cmath>

#include "data/simulator/random.h"

namespace walkgraph {

// White noise of three axes.
inline Eigen::Vector3d Noise(double sigma, Random* random) {
  const double x = random->Normal();
  const double y = random->Normal();
  const double z = random->Normal();
  return sigma * Eigen::Vector3d(x, y, z);
}

// A Gauss-Markov process (first order) that is started in its stationary distribution.
class Wander {
 public:
  Wander(double sigma, double time_constant_s, double dt_s, Random* random)
      : sigma_(sigma), keep_(std::exp(-dt_s / time_constant_s)), value_(random->Normal(0, sigma)) {}

  double Next(Random* random) {
    value_ = keep_ * value_ + sigma_ * std::sqrt(1.0 - keep_ * keep_) * random->Normal();
    return value_;
  }

 private:
  double sigma_;
  double keep_;
  double value_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_NOISE_H_
