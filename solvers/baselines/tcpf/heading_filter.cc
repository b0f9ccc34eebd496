#include "solvers/baselines/tcpf/heading_filter.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "data/angle.h"
#include "solvers/baselines/kalman.h"

namespace walkgraph {

FilteredHeading FilterHeading(const Stream<double>& gyro_yaw_rad, const Stream<double>& compass_rad,
                              const HeadingFilterSettings& settings) {
  using Scalar = Eigen::Matrix<double, 1, 1>;
  FilteredHeading filtered;
  if (gyro_yaw_rad.empty() || compass_rad.empty()) return filtered;
  const TimeNs begin = std::max(gyro_yaw_rad.time_ns.front(), compass_rad.time_ns.front());
  const TimeNs end = std::min(gyro_yaw_rad.time_ns.back(), compass_rad.time_ns.back());
  if (begin > end) return filtered;

  const double dt = settings.interval_s;
  const Eigen::Matrix2d a = (Eigen::Matrix2d() << 1, dt, 0, 1).finished();
  const Eigen::Vector2d b(dt * dt / 2, dt);
  const double variance = settings.acceleration_sigma_radps2 * settings.acceleration_sigma_radps2;
  const Eigen::Matrix2d process = variance * b * b.transpose();
  const Eigen::RowVector2d c(1, 0);
  const Scalar compass_variance(settings.compass_sigma_rad * settings.compass_sigma_rad);

  const auto rate_until = [&](TimeNs time) {
    return (Interpolate(gyro_yaw_rad, time) - Interpolate(gyro_yaw_rad, time - DurationNs(dt))) /
           dt;
  };
  double rate = rate_until(std::min(begin + DurationNs(dt), end));
  // The first compass reading is all that is known of the angle; the gyroscope gives the rate.
  KalmanState<2> state{{Interpolate(compass_rad, begin), rate},
                       Eigen::Vector2d(compass_variance(0), variance * dt * dt).asDiagonal()};
  for (TimeNs time = begin; time <= end; time += DurationNs(dt)) {
    if (time > begin) {
      const double next_rate = rate_until(time);
      state = KalmanPredict<2>(state, a, b * ((next_rate - rate) / dt), process);
      rate = next_rate;
      const Scalar innovation(WrapAngle(Interpolate(compass_rad, time) - state.mean(0)));
      state = KalmanUpdate<2, 1>(state, innovation, c, compass_variance);
    }
    filtered.heading_rad.push_back(time, state.mean(0));
    filtered.sigma_rad.push_back(std::sqrt(state.covariance(0, 0)));
  }
  return filtered;
}

Evidence WithFilteredHeading(const Evidence& evidence, const HeadingFilterSettings& settings) {
  FilteredHeading filtered =
      FilterHeading(evidence.gyro_yaw_rad, evidence.absolute_heading_rad, settings);
  Evidence result = evidence;
  result.absolute_heading_rad = std::move(filtered.heading_rad);
  result.absolute_heading_sigma_rad = std::move(filtered.sigma_rad);
  return result;
}

}  // namespace walkgraph
