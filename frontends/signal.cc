#include "frontends/signal.h"

#include <cstddef>

#include "data/angle.h"

namespace walkgraph {
namespace {

template <typename T>
std::vector<T> CenteredMeanOf(const std::vector<TimeNs>& time_ns, const std::vector<T>& value,
                              double window_s, const T& zero) {
  const std::size_t n = value.size();
  const TimeNs half_ns = DurationNs(window_s / 2);
  std::vector<T> sum_before(n + 1, zero);
  for (std::size_t i = 0; i < n; ++i) sum_before[i + 1] = sum_before[i] + value[i];
  std::vector<T> mean(n, zero);
  std::size_t first = 0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < n; ++i) {
    while (time_ns[first] < time_ns[i] - half_ns) ++first;
    while (last < n && time_ns[last] <= time_ns[i] + half_ns) ++last;
    mean[i] = (sum_before[last] - sum_before[first]) / static_cast<double>(last - first);
  }
  return mean;
}

template <typename T>
std::vector<T> ResampleOf(const Stream<T>& stream, const std::vector<TimeNs>& time_ns) {
  std::vector<T> out;
  if (stream.empty()) return out;
  out.reserve(time_ns.size());
  std::size_t after = 0;
  for (const TimeNs t : time_ns) {
    while (after < stream.size() && stream.time_ns[after] <= t) ++after;
    if (after == 0 || after == stream.size()) {
      out.push_back(after == 0 ? stream.value.front() : stream.value.back());
      continue;
    }
    const TimeNs t0 = stream.time_ns[after - 1];
    const double fraction = SecondsBetween(t0, t) / SecondsBetween(t0, stream.time_ns[after]);
    const T step = stream.value[after] - stream.value[after - 1];
    out.push_back(stream.value[after - 1] + fraction * step);
  }
  return out;
}

}  // namespace

std::vector<double> CenteredMean(const std::vector<TimeNs>& time_ns,
                                 const std::vector<double>& value, double window_s) {
  return CenteredMeanOf<double>(time_ns, value, window_s, 0.0);
}

std::vector<Eigen::Vector3d> CenteredMean(const std::vector<TimeNs>& time_ns,
                                          const std::vector<Eigen::Vector3d>& value,
                                          double window_s) {
  return CenteredMeanOf<Eigen::Vector3d>(time_ns, value, window_s, Eigen::Vector3d::Zero());
}

std::vector<Eigen::Vector3d> Resample(const Stream<Eigen::Vector3d>& stream,
                                      const std::vector<TimeNs>& time_ns) {
  return ResampleOf(stream, time_ns);
}

std::vector<double> Resample(const Stream<double>& stream, const std::vector<TimeNs>& time_ns) {
  return ResampleOf(stream, time_ns);
}

void Unwrap(std::vector<double>* angle_rad) {
  for (std::size_t i = 1; i < angle_rad->size(); ++i) {
    const double before = (*angle_rad)[i - 1];
    (*angle_rad)[i] = before + WrapAngle((*angle_rad)[i] - before);
  }
}

}  // namespace walkgraph
