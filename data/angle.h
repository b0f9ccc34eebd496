#ifndef WALKGRAPH_DATA_ANGLE_H_
#define WALKGRAPH_DATA_ANGLE_H_

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace walkgraph {

// Headings are radians counter-clockwise from +x of the building frame.

// The equivalent of `angle_rad` in [-pi, pi]. T is double or a ceres::Jet; the turns removed are a
// constant, so that the derivative is one.
template <typename T>
T WrapAngle(const T& angle_rad) {
  using std::floor;
  constexpr double kTurn = 2.0 * std::numbers::pi;
  return angle_rad - kTurn * floor((angle_rad + std::numbers::pi) / kTurn);
}

inline constexpr double DegreesToRadians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}
inline constexpr double RadiansToDegrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

// Unit vector along a heading.
inline Eigen::Vector2d DirectionOf(double heading_rad) {
  return {std::cos(heading_rad), std::sin(heading_rad)};
}

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_ANGLE_H_
