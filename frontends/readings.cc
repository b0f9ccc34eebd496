#include "frontends/readings.h"

#include <algorithm>
#include <tuple>

namespace walkgraph {

std::vector<RadioReading> UniqueReadings(const Recording& recording,
                                         std::map<std::string, std::int64_t>* counts) {
  const auto count = [&](std::uint32_t transmitter, const char* what) {
    ++(*counts)[std::string(RadioName(recording.transmitters[transmitter].radio)) + what];
  };
  std::vector<RadioReading> readings;
  readings.reserve(recording.radio_rows.size());
  for (const RadioRow& row : recording.radio_rows) {
    if (row.heard_ns > row.printed_ns) count(row.transmitter, "_heard_after_printed");
    readings.push_back({.heard_ns = std::min(row.heard_ns, row.printed_ns),
                        .printed_ns = row.printed_ns,
                        .transmitter = row.transmitter,
                        .rssi_dbm = row.rssi_dbm});
  }
  // Stable: rows of one reading stay in the order of printing, and the first one is kept.
  std::stable_sort(readings.begin(), readings.end(), [](const auto& a, const auto& b) {
    return std::tie(a.heard_ns, a.transmitter, a.printed_ns) <
           std::tie(b.heard_ns, b.transmitter, b.printed_ns);
  });
  std::vector<RadioReading> unique;
  const RadioReading* before = nullptr;
  for (const RadioReading& reading : readings) {
    const bool repeat = before != nullptr && before->heard_ns == reading.heard_ns &&
                        before->transmitter == reading.transmitter;
    before = &reading;
    if (repeat) {
      count(reading.transmitter, "_repeat");
    } else if (reading.heard_ns < recording.begin_ns) {
      count(reading.transmitter, "_before_begin");
    } else {
      unique.push_back(reading);
    }
  }
  return unique;
}

}  // namespace walkgraph
