#include "frontends/radio_map/reading_lag.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace walkgraph {
Evidence AlignReadings(const Site& site, Evidence evidence) {
  std::array<TimeNs, kRadioCount> lag_ns{};
  for (std::size_t r = 0; r < kRadioCount; ++r) lag_ns[r] = DurationNs(site.reading_lag_s[r]);
  for (RadioReading& reading : evidence.readings) {
    const auto radio = static_cast<std::size_t>(evidence.transmitters[reading.transmitter].radio);
    reading.heard_ns += lag_ns[radio];
    reading.printed_ns += lag_ns[radio];
  }
  std::stable_sort(
      evidence.readings.begin(), evidence.readings.end(),
      [](const RadioReading& a, const RadioReading& b) { return a.heard_ns < b.heard_ns; });
  return evidence;
}

}  // namespace walkgraph
