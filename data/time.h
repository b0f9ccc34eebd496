#ifndef WALKGRAPH_DATA_TIME_H_
#define WALKGRAPH_DATA_TIME_H_

#include <cstdint>

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

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_TIME_H_
