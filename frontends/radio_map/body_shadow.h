#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_BODY_SHADOW_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_BODY_SHADOW_H_

#include <Eigen/Core>
#include <cmath>

namespace walkgraph {

// Who holds a phone shields it from what lies behind: a reading taken while facing the direction
// h is a h . t(x) dB stronger than the mean over all directions, t the bearing of the transmitter
// and a the shadow's amplitude, half of what front and back differ by (up to 9 dB: Kaemarungsi and
// Krishnamurthy, MobiQuitous 2004). The field's own slope does not tell that bearing: walls and
// shadowing bend it.

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

// What the body adds to one reading.
struct BodyShadow {
  double value_db = 0;
  Eigen::Vector2d by_position = Eigen::Vector2d::Zero();  // dB/m
  double by_heading = 0;                                  // dB/rad
};

// Of somebody who faces `ahead`, a unit vector.
inline BodyShadow ShadowOf(double amplitude_db, const Bearing& bearing,
                           const Eigen::Vector2d& ahead) {
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  return {amplitude_db * ahead.dot(bearing.value), amplitude_db * bearing.by_position * ahead,
          amplitude_db * left.dot(bearing.value)};
}

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_BODY_SHADOW_H_
