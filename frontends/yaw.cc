#include "frontends/yaw.h"

#include <cstddef>
#include <vector>

#include "frontends/gravity.h"

namespace walkgraph {

Stream<double> IntegrateYaw(const Stream<Eigen::Vector3d>& gyroscope_radps,
                            const Stream<Eigen::Vector3d>& up, const YawSettings& settings,
                            std::map<std::string, std::int64_t>* counts) {
  Stream<double> yaw;
  if (gyroscope_radps.empty() || up.empty()) return yaw;
  const std::vector<Eigen::Vector3d> vertical = UpAt(up, gyroscope_radps.time_ns);
  yaw.time_ns = gyroscope_radps.time_ns;
  yaw.value.reserve(yaw.time_ns.size());
  yaw.value.push_back(0);
  double rate_before = gyroscope_radps.value.front().dot(vertical.front());
  for (std::size_t i = 1; i < gyroscope_radps.size(); ++i) {
    const double dt_s = SecondsBetween(yaw.time_ns[i - 1], yaw.time_ns[i]);
    const double rate = gyroscope_radps.value[i].dot(vertical[i]);
    if (dt_s > settings.max_gap_s) ++(*counts)["gyroscope_gap"];
    yaw.value.push_back(yaw.value.back() + 0.5 * (rate_before + rate) * dt_s);
    rate_before = rate;
  }
  return yaw;
}

}  // namespace walkgraph
