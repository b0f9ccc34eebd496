#include "data/simulator/magnetic.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "data/angle.h"
#include "data/simulator/noise.h"

namespace walkgraph {
namespace {

constexpr double kPhoneHeightM = 1.2;

Eigen::AngleAxisd AboutVertical(double angle_rad) { return {angle_rad, Eigen::Vector3d::UnitZ()}; }

// How far magnetic north is off, counter-clockwise: seen from a field in building axes.
double NorthError(const Eigen::Vector3d& field_ut, double rotation_rad) {
  const double north = 0.5 * std::numbers::pi - rotation_rad;
  return WrapAngle(std::atan2(field_ut.y(), field_ut.x()) - north);
}

}  // namespace

MagneticField::MagneticField(const MagneticSettings& settings, double rotation_rad, Random* random)
    : earth_ut_(AboutVertical(-rotation_rad) *
                Eigen::Vector3d(0.0, settings.horizontal_ut, -settings.vertical_ut)),
      disturbance_ut_(settings.disturbance_ut),
      disturbance_{ShadowField::Spatial(settings.disturbance_length_m, random),
                   ShadowField::Spatial(settings.disturbance_length_m, random),
                   ShadowField::Spatial(settings.disturbance_length_m, random)} {}

Eigen::Vector3d MagneticField::At(const Eigen::Vector3d& position_m) const {
  if (disturbance_ut_ == 0.0) return earth_ut_;
  return earth_ut_ + disturbance_ut_ * Eigen::Vector3d(disturbance_[0].At(position_m),
                                                       disturbance_[1].At(position_m),
                                                       disturbance_[2].At(position_m));
}

void SimulateMagnetic(const std::vector<WalkState>& states,
                      const std::vector<Eigen::Quaterniond>& attitudes, const MagneticField& field,
                      const MagneticSettings& settings, double rotation_rad, Random* random,
                      Recording* recording) {
  const double state_s = SecondsBetween(states[0].time_ns, states[1].time_ns);
  const auto every = std::max<std::size_t>(
      1, static_cast<std::size_t>(std::lround(1.0 / settings.rate_hz / state_s)));
  const double dt_s = state_s * static_cast<double>(every);
  const double offset = random->Normal(0.0, settings.yaw_offset_sigma_rad);
  Wander wander(settings.yaw_wander_rad, settings.yaw_wander_s, dt_s, random);
  const double follow = settings.fusion_s > 0.0 ? 1.0 - std::exp(-dt_s / settings.fusion_s) : 1.0;
  double north_error = 0;
  for (std::size_t i = 0; i < states.size(); i += every) {
    // Everything that looks north is turned by the error, the field that the phone measures with
    // it.
    const double error = offset + wander.Next(random);
    const Eigen::Vector3d place(states[i].position_m.x(), states[i].position_m.y(),
                                states[i].height_m + kPhoneHeightM);
    const Eigen::Vector3d local_ut = field.At(place);
    const double seen_error = -NorthError(local_ut, rotation_rad);
    north_error += (i == 0 ? 1.0 : follow) * WrapAngle(seen_error - north_error);
    Eigen::Quaterniond seen = AboutVertical(rotation_rad + error + north_error) * attitudes[i];
    if (seen.w() < 0) seen.coeffs() = -seen.coeffs();
    recording->rotation_vector.push_back(states[i].time_ns, seen);
    recording->magnetometer_ut.push_back(
        states[i].time_ns, attitudes[i].conjugate() * (AboutVertical(-error) * local_ut) +
                               Noise(settings.noise_ut, random));
  }
}

}  // namespace walkgraph
