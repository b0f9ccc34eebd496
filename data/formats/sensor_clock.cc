#include "data/formats/sensor_clock.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace walkgraph {
namespace {

// Longer than any delay of an application that is still recording (a quarter of a second is the
// longest in the IPIN 2023 logs), shorter than a clock that was set.
constexpr TimeNs kLongestDelayNs = kNsPerSecond / 2;

}  // namespace

std::optional<TimeNs> ClockOffset(const TwoClocks& clocks) {
  const std::size_t count = clocks.application_ns.size();
  if (count == 0) return std::nullopt;
  std::vector<TimeNs> offset(count);
  for (std::size_t i = 0; i < count; ++i) {
    offset[i] = clocks.application_ns[i] - clocks.sensor_ns[i];
  }
  const auto middle = offset.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(offset.begin(), middle, offset.end());
  return *middle;
}

std::vector<TimeNs> AlignToApplication(const TwoClocks& clocks, ReadReport* report) {
  std::vector<TimeNs> time_ns = clocks.application_ns;
  const std::optional<TimeNs> offset = ClockOffset(clocks);
  std::int64_t jumps = 0;
  for (std::size_t i = 0; i < time_ns.size(); ++i) {
    const TimeNs aligned = clocks.sensor_ns[i] + *offset;
    if (std::llabs(aligned - time_ns[i]) > kLongestDelayNs) {
      ++jumps;
    } else {
      time_ns[i] = aligned;
    }
  }
  if (jumps > 0) report->hazards["sensor_clock_jump"] += jumps;
  return time_ns;
}

}  // namespace walkgraph
