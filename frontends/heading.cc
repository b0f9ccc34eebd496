#include "frontends/heading.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "frontends/gravity.h"
#include "frontends/signal.h"

namespace walkgraph {
namespace {

constexpr double kMinHorizontal = 0.3;  // sine of 17 degrees

// Adds the heading of a phone whose x axis points (east, north) in the horizontal plane, scaled
// such that a horizontal axis has length one.
void AppendHeading(TimeNs time_ns, double x_east, double x_north, Stream<double>* heading_rad,
                   std::map<std::string, std::int64_t>* counts) {
  if (!(std::hypot(x_east, x_north) >= kMinHorizontal)) {
    ++(*counts)["heading_undefined"];
    return;
  }
  heading_rad->push_back(time_ns, std::atan2(x_east, -x_north));
}

// Standard deviation of heading minus gyroscope yaw inside the window around each sample.
std::vector<double> DriftAgainstGyroscope(const Stream<double>& heading_rad,
                                          const Stream<double>& yaw_rad, double window_s) {
  std::vector<double> drift = Resample(yaw_rad, heading_rad.time_ns);
  if (drift.empty()) return std::vector<double>(heading_rad.size(), 0.0);
  const double start = heading_rad.value.front() - drift.front();
  for (std::size_t i = 0; i < drift.size(); ++i) drift[i] = heading_rad.value[i] - drift[i] - start;
  std::vector<double> square(drift.size());
  std::transform(drift.begin(), drift.end(), square.begin(), [](double d) { return d * d; });
  const std::vector<double> mean = CenteredMean(heading_rad.time_ns, drift, window_s);
  std::vector<double> sigma = CenteredMean(heading_rad.time_ns, square, window_s);
  for (std::size_t i = 0; i < sigma.size(); ++i) {
    sigma[i] = std::sqrt(std::max(sigma[i] - mean[i] * mean[i], 0.0));
  }
  return sigma;
}

}  // namespace

Stream<double> RotationVectorHeading(const Stream<Eigen::Quaterniond>& rotation_vector,
                                     std::map<std::string, std::int64_t>* counts) {
  Stream<double> heading;
  for (std::size_t i = 0; i < rotation_vector.size(); ++i) {
    const Eigen::Vector3d x = rotation_vector.value[i] * Eigen::Vector3d::UnitX();
    AppendHeading(rotation_vector.time_ns[i], x.x(), x.y(), &heading, counts);
  }
  Unwrap(&heading.value);
  return heading;
}

Stream<double> MagnetometerHeading(const Stream<Eigen::Vector3d>& magnetometer_ut,
                                   const Stream<Eigen::Vector3d>& up,
                                   std::map<std::string, std::int64_t>* counts) {
  Stream<double> heading;
  if (up.empty()) return heading;
  const std::vector<Eigen::Vector3d> vertical = UpAt(up, magnetometer_ut.time_ns);
  for (std::size_t i = 0; i < magnetometer_ut.size(); ++i) {
    // The field points north and down, so that its product with up points east.
    const Eigen::Vector3d east = magnetometer_ut.value[i].cross(vertical[i]);
    const double norm = east.norm();
    const Eigen::Vector3d east_unit = norm > 0 ? Eigen::Vector3d(east / norm) : east;
    const Eigen::Vector3d north_unit = vertical[i].cross(east_unit);
    AppendHeading(magnetometer_ut.time_ns[i], east_unit.x(), north_unit.x(), &heading, counts);
  }
  Unwrap(&heading.value);
  return heading;
}

HeadingStream AbsoluteHeading(const Recording& recording, const Stream<Eigen::Vector3d>& up,
                              const Stream<double>& yaw_rad, const HeadingQualitySettings& settings,
                              std::map<std::string, std::int64_t>* counts) {
  HeadingStream out;
  out.heading_rad = RotationVectorHeading(recording.rotation_vector, counts);
  if (out.heading_rad.empty()) {
    out.heading_rad = MagnetometerHeading(recording.magnetometer_ut, up, counts);
  }
  if (!out.heading_rad.empty()) {
    out.sigma_rad = DriftAgainstGyroscope(out.heading_rad, yaw_rad, settings.window_s);
  }
  return out;
}

}  // namespace walkgraph
