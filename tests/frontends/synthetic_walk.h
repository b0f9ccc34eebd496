#ifndef WALKGRAPH_TESTS_FRONTENDS_SYNTHETIC_WALK_H_
#define WALKGRAPH_TESTS_FRONTENDS_SYNTHETIC_WALK_H_

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "data/recording.h"
#include "frontends/gravity.h"

namespace walkgraph {

// A phone carried by somebody who stands, takes a known number of steps and stands again.
struct SyntheticWalk {
  double rate_hz = 50;
  double stand_s = 3;  // before and after walking
  double cadence_hz = 1.8;
  int steps = 20;
  double swing_mps2 = 4;     // peak to peak of the vertical acceleration at the step frequency
  double second_bump = 0.3;  // relative size of the second harmonic
  double noise_mps2 = 0.1;
  double yaw_rate_radps = 0;  // turning while walking
  // Device to walker (x right, y ahead, z up): how the phone is held.
  Eigen::Quaterniond hold = Eigen::Quaterniond::Identity();
  std::uint32_t seed = 1;

  double walk_s() const { return steps / cadence_hz; }
  double duration_s() const { return 2 * stand_s + walk_s(); }
};

inline constexpr TimeNs kSyntheticBeginNs = 1'600'000'000'000'000'000;

// Walking direction is north (heading pi/2) until the walker turns. Steps are whole periods of the
// vertical acceleration, from one lowest point to the next.
inline Recording Simulate(const SyntheticWalk& walk) {
  Recording out;
  std::mt19937 random(walk.seed);
  std::normal_distribution<double> noise(0, walk.noise_mps2);
  const Eigen::Quaterniond to_device = walk.hold.conjugate();
  const Eigen::Vector3d field_enu(0, 30, -40);
  const int n = static_cast<int>(walk.duration_s() * walk.rate_hz) + 1;
  for (int i = 0; i < n; ++i) {
    const double t = i / walk.rate_hz;
    const TimeNs time_ns = kSyntheticBeginNs + DurationNs(t);
    const double walked_s = std::clamp(t - walk.stand_s, 0.0, walk.walk_s());
    const bool walking = walked_s > 0 && walked_s < walk.walk_s();
    const double phase = 2 * std::numbers::pi * walk.cadence_hz * walked_s;
    const double bounce =
        walking ? -walk.swing_mps2 / 2 * (std::cos(phase) + walk.second_bump * std::sin(2 * phase))
                : 0;
    const double yaw = walk.yaw_rate_radps * walked_s;
    const Eigen::Quaterniond walker_to_enu(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
    const Eigen::Vector3d force(noise(random), noise(random),
                                kStandardGravityMps2 + bounce + noise(random));
    const Eigen::Vector3d rate(0, 0, walking ? walk.yaw_rate_radps : 0);
    out.accelerometer_mps2.push_back(time_ns, to_device * force);
    out.gyroscope_radps.push_back(time_ns, to_device * rate);
    out.magnetometer_ut.push_back(time_ns, to_device * (walker_to_enu.conjugate() * field_enu));
    out.rotation_vector.push_back(time_ns, walker_to_enu * walk.hold);
  }
  out.begin_ns = out.accelerometer_mps2.time_ns.front();
  out.end_ns = out.accelerometer_mps2.time_ns.back();
  return out;
}

inline Eigen::Quaterniond Turn(double angle_rad, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, axis));
}

}  // namespace walkgraph

#endif  // WALKGRAPH_TESTS_FRONTENDS_SYNTHETIC_WALK_H_
