#include "frontends/radio_map/sweeps.h"

#include <algorithm>
#include <map>

namespace walkgraph {

std::vector<Sweep> GroupSweeps(const Evidence& evidence, Radio radio) {
  // Wi-Fi rows of one scan share their printed time; beacons report one by one.
  const TimeNs bin_ns = radio == Radio::kBeacon ? kNsPerSecond : 1;
  std::map<TimeNs, Sweep> by_print;
  for (std::size_t i = 0; i < evidence.readings.size(); ++i) {
    const RadioReading& reading = evidence.readings[i];
    if (evidence.transmitters[reading.transmitter].radio != radio) continue;
    // Rounded down also before zero, where a division alone would join the seconds on its sides.
    const TimeNs into_bin = ((reading.printed_ns % bin_ns) + bin_ns) % bin_ns;
    by_print[reading.printed_ns - into_bin].readings.push_back(i);
  }
  std::vector<Sweep> sweeps;
  sweeps.reserve(by_print.size());
  for (auto& [bin, sweep] : by_print) {
    // Offsets from the first keep the mean of 64-bit times exact enough.
    const TimeNs first = evidence.readings[sweep.readings.front()].heard_ns;
    TimeNs sum = 0;
    for (const std::size_t i : sweep.readings) sum += evidence.readings[i].heard_ns - first;
    sweep.mean_heard_ns = first + sum / static_cast<TimeNs>(sweep.readings.size());
    sweeps.push_back(std::move(sweep));
  }
  std::stable_sort(sweeps.begin(), sweeps.end(), [](const Sweep& a, const Sweep& b) {
    return a.mean_heard_ns < b.mean_heard_ns;
  });
  return sweeps;
}

}  // namespace walkgraph
