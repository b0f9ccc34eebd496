#include "frontends/magnetic.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "frontends/gravity.h"

namespace walkgraph {

Stream<MagneticSample> MagneticField(const Stream<Eigen::Vector3d>& magnetometer_ut,
                                     const Stream<Eigen::Vector3d>& up) {
  Stream<MagneticSample> out;
  if (up.empty()) return out;
  const std::vector<Eigen::Vector3d> vertical = UpAt(up, magnetometer_ut.time_ns);
  for (std::size_t i = 0; i < magnetometer_ut.size(); ++i) {
    const Eigen::Vector3d& field = magnetometer_ut.value[i];
    const double norm = field.norm();
    const double sine = norm > 0 ? std::clamp(-field.dot(vertical[i]) / norm, -1.0, 1.0) : 0.0;
    out.push_back(magnetometer_ut.time_ns[i],
                  {.norm_ut = norm, .inclination_rad = std::asin(sine)});
  }
  return out;
}

}  // namespace walkgraph
