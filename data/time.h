#ifndef WALKGRAPH_DATA_TIME_H_
#define WALKGRAPH_DATA_TIME_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace walkgraph {

// Nanoseconds of the recording's own clock (Unix time for ilc20, AppTimestamp for GetSensorData).
// Never rebased: outputs carry the times of the inputs.
using TimeNs = std::int64_t;

inline constexpr TimeNs kNsPerMs = 1'000'000;
inline constexpr TimeNs kNsPerSecond = 1'000'000'000;

// Seconds from `begin` to `end`; negative where `end` is earlier.
inline double SecondsBetween(TimeNs begin, TimeNs end) {
  return static_cast<double>(end - begin) * 1e-9;
}

// `seconds` as a duration in nanoseconds, rounded to the nearest.
inline TimeNs DurationNs(double seconds) {
  const double ns = seconds * 1e9;
  return static_cast<TimeNs>(ns < 0 ? ns - 0.5 : ns + 0.5);
}

// Index of the time nearest to `time_ns`, of two equally near the earlier. Precondition: `times` is
// sorted and not empty.
inline std::size_t NearestTime(std::span<const TimeNs> times, TimeNs time_ns) {
  const auto after = std::lower_bound(times.begin(), times.end(), time_ns);
  const auto i = static_cast<std::size_t>(after - times.begin());
  if (i == 0) return 0;
  if (i == times.size()) return i - 1;
  return time_ns - times[i - 1] <= times[i] - time_ns ? i - 1 : i;
}

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_TIME_H_
