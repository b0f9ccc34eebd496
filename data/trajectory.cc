#include "data/trajectory.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace walkgraph {

PoseEstimate Trajectory::At(TimeNs time_ns) const {
  if (poses.empty()) throw std::logic_error("Trajectory::At on an empty trajectory");
  const auto after =
      std::upper_bound(poses.begin(), poses.end(), time_ns,
                       [](TimeNs time, const PoseEstimate& pose) { return time < pose.time_ns; });
  PoseEstimate result;
  if (after == poses.begin()) {
    result = poses.front();
  } else if (after == poses.end()) {
    result = poses.back();
  } else {
    const PoseEstimate& a = *(after - 1);
    const PoseEstimate& b = *after;
    const double f = SecondsBetween(a.time_ns, time_ns) / SecondsBetween(a.time_ns, b.time_ns);
    const auto mix = [f](const auto& from, const auto& to) { return (1.0 - f) * from + f * to; };
    result = f < 0.5 ? a : b;
    result.position_m = mix(a.position_m, b.position_m);
    result.heading_rad = mix(a.heading_rad, b.heading_rad);
    result.covariance_xy_m2 = mix(a.covariance_xy_m2, b.covariance_xy_m2);
    result.variance_z_m2 = mix(a.variance_z_m2, b.variance_z_m2);
    result.variance_heading_rad2 = mix(a.variance_heading_rad2, b.variance_heading_rad2);
  }
  result.time_ns = time_ns;
  return result;
}

}  // namespace walkgraph
