#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_BEARING_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_BEARING_H_

#include <Eigen/Core>
#include <cmath>

namespace walkgraph {

// Nearer to a transmitter than this (m) its bearing is not known: its place is that of loud
// readings.
inline constexpr double kBearingSoftness = 10.0;

// From a place towards where a transmitter seems to stand, q / sqrt(q^2 + kBearingSoftness^2) with
// q the way there: a unit vector from afar, shorter near by, where the direction is not known.
struct Bearing {
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
  Eigen::Matrix2d by_position = Eigen::Matrix2d::Zero();  // 1/m, symmetric
};

inline Bearing BearingOf(const Eigen::Vector2d& source_m, const Eigen::Vector2d& position_m) {
  const Eigen::Vector2d way = source_m - position_m;
  const double length = std::hypot(way.norm(), kBearingSoftness);
  const Eigen::Vector2d value = way / length;
  return {value, (value * value.transpose() - Eigen::Matrix2d::Identity()) / length};
}

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_BEARING_H_
