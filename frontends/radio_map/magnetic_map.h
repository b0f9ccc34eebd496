#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_MAGNETIC_MAP_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_MAGNETIC_MAP_H_

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <vector>

#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/radio_map.h"

namespace walkgraph {

// Walked in which the field of a building hardly changes: magnetic samples are means over it, s.
inline constexpr double kMagneticSampleS = 0.5;

// The horizontal and the downward component of the field, microtesla: what a phone measures alike
// whichever way it is turned, and, unlike norm and inclination, what noise adds to.
inline Eigen::Vector2d MagneticComponents(const MagneticSample& sample) {
  return {sample.norm_ut * std::cos(sample.inclination_rad),
          sample.norm_ut * std::sin(sample.inclination_rad)};
}

// The magnetic field of one floor, bent by the steel of the building from metre to metre. Each
// component has a mean and a spread everywhere, both splines on one grid; away from all survey
// samples they are those of the floor as a whole.
struct MagneticMap {
  struct Component {
    std::vector<float> mean_ut, log_sigma;  // control values on the grid, row-major; of microtesla
  };

  int floor = 0;
  FieldGrid grid;
  std::array<Component, 2> components;  // as MagneticComponents
  double sigma_min_ut = 0;              // the smallest spread of either
  // Calibrated on survey walks held out in turn: samples of so long are worth one, s, and the sigma
  // of the slow error of position that all samples at a place share (survey paths drawn beside
  // those that were walked), per axis.
  double correlation_s = 0;
  double map_error_sigma_m = 0;

  ScalarValue Mean(int component, const FieldBasis& basis) const {
    return EvaluateField(grid, components[static_cast<std::size_t>(component)].mean_ut, basis);
  }
  ScalarValue LogSigma(int component, const FieldBasis& basis) const {
    return EvaluateField(grid, components[static_cast<std::size_t>(component)].log_sigma, basis);
  }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_MAGNETIC_MAP_H_
