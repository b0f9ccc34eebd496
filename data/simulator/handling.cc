#include "data/simulator/handling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace walkgraph {
namespace {

// Measured on ipin2023, seconds 5 to 35: 3.0 rad/s (root mean square) about each axis, and a norm
// of the specific force that deviates by 3.7 m/s^2.
constexpr double kAngleRad = 0.9;
constexpr double kAccelerationMps2 = 5.0;
constexpr double kSlowestHz = 0.5;
constexpr double kFastestHz = 1.0;
constexpr double kFadeS = 1.0;

}  // namespace

Handling::Handling(double duration_s, Random random) : duration_s_(duration_s) {
  for (auto* swings : {&rotation_, &motion_}) {
    for (Swing& swing : *swings) {
      swing.frequency_hz = random.Uniform(kSlowestHz, kFastestHz);
      swing.phase_rad = random.Uniform(0.0, 2.0 * std::numbers::pi);
    }
  }
}

double Handling::Swing::At(double time_s) const {
  return std::sin(2.0 * std::numbers::pi * frequency_hz * time_s + phase_rad);
}

double Handling::Strength(double time_s) const {
  const double left = std::clamp((duration_s_ - time_s) / kFadeS, 0.0, 1.0);
  return left * left * (3.0 - 2.0 * left);
}

Eigen::Quaterniond Handling::Rotation(double time_s) const {
  const double angle = kAngleRad * Strength(time_s);
  return Eigen::AngleAxisd(angle * rotation_[0].At(time_s), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(angle * rotation_[1].At(time_s), Eigen::Vector3d::UnitX()) *
         Eigen::AngleAxisd(angle * rotation_[2].At(time_s), Eigen::Vector3d::UnitY());
}

Eigen::Vector3d Handling::Acceleration(double time_s) const {
  return kAccelerationMps2 * Strength(time_s) *
         Eigen::Vector3d(motion_[0].At(time_s), motion_[1].At(time_s), motion_[2].At(time_s));
}

}  // namespace walkgraph
