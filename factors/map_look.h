#ifndef WALKGRAPH_FACTORS_MAP_LOOK_H_
#define WALKGRAPH_FACTORS_MAP_LOOK_H_

#include <Eigen/Core>
#include <cmath>

#include "factors/settings.h"
#include "frontends/radio_map/radio_map.h"

namespace walkgraph {

// How much larger the map's error is at a place than on the survey. The error state e is that on
// the survey, of standard deviation s; d metres away, where the map extrapolates, it is r e with
//   r = sqrt(1 + (g d)^2),   g = map_error_growth / s.
struct ErrorRatio {
  double value = 1;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();  // 1/m
};

// g, 1/m, where the error state has standard deviation `sigma_m`; 0 where the error does not grow.
inline double GrowthPerSigma(const RadioMap& map, const MapErrorSettings& settings,
                             double sigma_m) {
  return settings.grows && sigma_m > 0 ? map.map_error_growth / sigma_m : 0.0;
}

// `growth_per_sigma` is g, 1/m.
inline ErrorRatio ErrorRatioAt(const RadioMap& map, double growth_per_sigma,
                               const Eigen::Vector2d& position) {
  if (growth_per_sigma <= 0) return {};
  const ScalarValue distance = map.SurveyDistance(EvaluateBasis(map.grid, position));
  const double grown = growth_per_sigma * distance.value;
  const double ratio = std::hypot(1.0, grown);
  return {ratio, growth_per_sigma * grown / ratio * distance.gradient};
}

// Where in the map a factor looks that stands at x and has map error e: at u = x + r(x) e.
class MapLook {
 public:
  MapLook(const RadioMap& map, double growth_per_sigma, const double* position,
          const double* map_error)
      : error_(map_error[0], map_error[1]),
        ratio_(ErrorRatioAt(map, growth_per_sigma, {position[0], position[1]})),
        place_(Eigen::Vector2d(position[0], position[1]) + ratio_.value * error_),
        basis_(EvaluateBasis(map.grid, place_)) {}

  const Eigen::Vector2d& place() const { return place_; }  // u, m
  const FieldBasis& basis() const { return basis_; }

  // Writes a row of the Jacobians by position (block 0) and map error (block 1) of what has
  // `gradient` by u.
  void FillRow(double** jacobians, int row, const Eigen::Vector2d& gradient) const {
    if (jacobians[0] != nullptr) {
      const Eigen::Vector2d by_position = gradient + gradient.dot(error_) * ratio_.gradient;
      jacobians[0][2 * row] = by_position.x();
      jacobians[0][2 * row + 1] = by_position.y();
    }
    if (jacobians[1] != nullptr) {
      jacobians[1][2 * row] = ratio_.value * gradient.x();
      jacobians[1][2 * row + 1] = ratio_.value * gradient.y();
    }
  }

 private:
  Eigen::Vector2d error_;
  ErrorRatio ratio_;
  Eigen::Vector2d place_;
  FieldBasis basis_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_MAP_LOOK_H_
