#include "frontends/gravity.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>

#include "frontends/signal.h"

namespace walkgraph {
namespace {

// `v` at unit length, or `fallback` where it has no direction.
Eigen::Vector3d Direction(const Eigen::Vector3d& v, const Eigen::Vector3d& fallback) {
  const double norm = v.norm();
  return norm > 1e-6 ? Eigen::Vector3d(v / norm) : fallback;
}

Eigen::Vector3d StartDirection(const Stream<Eigen::Vector3d>& force, double window_s) {
  const TimeNs end = force.time_ns.front() + DurationNs(window_s);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < force.size() && force.time_ns[i] <= end; ++i) sum += force.value[i];
  return Direction(sum, Eigen::Vector3d::UnitZ());
}

}  // namespace

Stream<Eigen::Vector3d> EstimateUp(const Recording& recording,
                                   const GravityFilterSettings& settings) {
  const Stream<Eigen::Vector3d>& force = recording.accelerometer_mps2;
  Stream<Eigen::Vector3d> up;
  if (force.empty()) return up;
  const std::vector<Eigen::Vector3d> rate = Resample(recording.gyroscope_radps, force.time_ns);
  up.time_ns = force.time_ns;
  up.value.reserve(force.size());
  up.value.push_back(StartDirection(force, settings.start_window_s));
  for (std::size_t i = 1; i < force.size(); ++i) {
    const double dt_s = SecondsBetween(force.time_ns[i - 1], force.time_ns[i]);
    Eigen::Vector3d u = up.value.back();
    // A vector that stands still in the world turns against the device.
    if (!rate.empty()) u += u.cross(0.5 * dt_s * (rate[i - 1] + rate[i]));
    const double pull = std::clamp(dt_s / settings.time_constant_s, 0.0, 1.0);
    u += pull * (force.value[i] / kStandardGravityMps2 - u);
    up.value.push_back(Direction(u, up.value.back()));
  }
  return up;
}

std::vector<Eigen::Vector3d> UpAt(const Stream<Eigen::Vector3d>& up,
                                  const std::vector<TimeNs>& time_ns) {
  std::vector<Eigen::Vector3d> out = Resample(up, time_ns);
  for (Eigen::Vector3d& u : out) u = Direction(u, Eigen::Vector3d::UnitZ());
  return out;
}

}  // namespace walkgraph
