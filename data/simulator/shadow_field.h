#ifndef WALKGRAPH_DATA_SIMULATOR_SHADOW_FIELD_H_
#define WALKGRAPH_DATA_SIMULATOR_SHADOW_FIELD_H_

#include <Eigen/Core>
#include <vector>

#include "data/simulator/random.h"

namespace walkgraph {

// A stationary random field with mean 0, sigma 1 and correlation exp(-d / length): a sum of plane
// waves whose wave vectors follow the spectrum of that correlation.
class ShadowField {
 public:
  // Over the plane, the same at every height.
  static ShadowField Planar(double correlation_length_m, Random* random);
  // In space.
  static ShadowField Spatial(double correlation_length_m, Random* random);

  double At(const Eigen::Vector3d& position_m) const;

 private:
  struct Wave {
    Eigen::Vector3d wave_vector;  // rad/m
    double phase_rad;
  };
  std::vector<Wave> waves_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_SHADOW_FIELD_H_
