#include "factors/map_sweeps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "factors/refresh_rate.h"
#include "frontends/radio_map/sweeps.h"

namespace walkgraph {
namespace {

double ScanWeight(std::size_t readings, const RadioMap& map, const FingerprintSettings& settings) {
  const double n_eff = settings.n_eff > 0 ? settings.n_eff : map.n_eff;
  return n_eff > 0 ? std::min(1.0, n_eff / static_cast<double>(readings)) : 1.0;
}

float RefreshPrecision(const Evidence& evidence, const RadioReading& reading) {
  if (MotionStateAt(evidence, reading.heard_ns) != MotionState::kWalking) return 1;
  return static_cast<float>(RefreshRate().Weight(reading.rssi_dbm));
}

TimeNs MeanHeard(const std::vector<MapSweep::Reading>& readings) {
  // Relative to the first: Unix nanoseconds are too large to sum.
  const TimeNs origin = readings.front().heard_ns;
  TimeNs sum = 0;
  for (const MapSweep::Reading& reading : readings) sum += reading.heard_ns - origin;
  return origin + sum / static_cast<TimeNs>(readings.size());
}

// Cuts a scan's readings (by heard_ns) into parts of equal duration and appends those not empty.
void AppendParts(const MapSweep& scan, double max_span_s, std::vector<MapSweep>* sweeps) {
  const TimeNs begin = scan.readings.front().heard_ns;
  const double span_s = SecondsBetween(begin, scan.readings.back().heard_ns);
  const int parts = span_s > max_span_s ? static_cast<int>(std::ceil(span_s / max_span_s)) : 1;
  std::vector<MapSweep::Reading> rest = scan.readings;
  auto first = rest.cbegin();
  for (int part = 1; part <= parts; ++part) {
    const TimeNs end = begin + DurationNs(span_s * part / parts);
    const auto last =
        part == parts ? rest.cend()
                      : std::find_if(first, rest.cend(), [end](const MapSweep::Reading& reading) {
                          return reading.heard_ns >= end;
                        });
    if (first == last) continue;
    MapSweep sweep = scan;
    sweep.readings.assign(first, last);
    sweep.mean_heard_ns = MeanHeard(sweep.readings);
    sweep.silence_share =
        static_cast<double>(sweep.readings.size()) / static_cast<double>(scan.readings.size());
    sweeps->push_back(std::move(sweep));
    first = last;
  }
}

}  // namespace

std::vector<MapSweep> CollectMapSweeps(const Site& site, const RadioMap& map,
                                       const Evidence& evidence,
                                       const FingerprintSettings& settings, double max_span_s) {
  const std::vector<std::int32_t> site_index = MatchTransmitters(site, evidence);
  std::vector<int> field_of(site_index.size(), -1);
  for (std::size_t i = 0; i < site_index.size(); ++i) {
    if (site_index[i] == kUnknownTransmitter) continue;
    field_of[i] = map.FindField(static_cast<std::uint32_t>(site_index[i]));
  }
  std::vector<MapSweep> sweeps;
  for (const Sweep& scan : GroupSweeps(evidence, map.radio)) {
    MapSweep known;
    known.radio = map.radio;
    known.printed_ns = evidence.readings[scan.readings.front()].printed_ns;
    for (const std::size_t i : scan.readings) {
      const RadioReading& reading = evidence.readings[i];
      if (field_of[reading.transmitter] < 0 || reading.rssi_dbm < settings.min_rssi_dbm) continue;
      known.readings.push_back({field_of[reading.transmitter], reading.rssi_dbm, reading.heard_ns,
                                settings.refresh_rate ? RefreshPrecision(evidence, reading) : 1});
    }
    if (known.readings.empty()) continue;
    known.weight = ScanWeight(known.readings.size(), map, settings);
    AppendParts(known, max_span_s, &sweeps);
  }
  std::stable_sort(sweeps.begin(), sweeps.end(), [](const MapSweep& a, const MapSweep& b) {
    return a.mean_heard_ns < b.mean_heard_ns;
  });
  return sweeps;
}

std::vector<MapSweep> CollectMapSweeps(const Site& site, const RadioMap& map,
                                       const Evidence& evidence,
                                       const FingerprintSettings& settings, const FloorPath& floors,
                                       double max_span_s) {
  std::vector<MapSweep> sweeps = CollectMapSweeps(site, map, evidence, settings, max_span_s);
  std::erase_if(sweeps,
                [&](const MapSweep& sweep) { return floors.At(sweep.mean_heard_ns) != map.floor; });
  return sweeps;
}

std::vector<const RadioMap*> MapsOnPath(const Site& site, const FingerprintSettings& settings,
                                        const FloorPath& floors) {
  std::vector<const RadioMap*> maps;
  for (const int floor : floors.Floors()) {
    for (const Radio radio : kAllRadios) {
      const RadioMap* map = settings.Uses(radio) ? site.FindMap(floor, radio) : nullptr;
      if (map != nullptr) maps.push_back(map);
    }
  }
  return maps;
}

}  // namespace walkgraph
