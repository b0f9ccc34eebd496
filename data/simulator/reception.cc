#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "data/simulator/radio.h"

namespace walkgraph {
namespace {

// Streams of random numbers beside the main one.
enum RandomStream : std::uint64_t { kDeviceOffset };

struct Heard {
  TimeNs heard_ns = 0;
  double rssi_dbm = 0;
};

// Rows with the number of their sender.
using SenderRows = std::vector<std::pair<std::size_t, RadioRow>>;

// Prints everything that the phone still remembers, strongest first as Android does.
void PrintScan(TimeNs printed_ns, const std::map<std::size_t, Heard>& memory, double keep_s,
               SenderRows* rows) {
  const std::size_t begin = rows->size();
  for (const auto& [access_point, heard] : memory) {
    if (SecondsBetween(heard.heard_ns, printed_ns) > keep_s) continue;
    RadioRow row;
    row.printed_ns = printed_ns;
    row.heard_ns = heard.heard_ns;
    row.rssi_dbm = static_cast<float>(heard.rssi_dbm);
    rows->emplace_back(access_point, row);
  }
  std::stable_sort(
      rows->begin() + static_cast<std::ptrdiff_t>(begin), rows->end(),
      [](const auto& a, const auto& b) { return a.second.rssi_dbm > b.second.rssi_dbm; });
}

TimeNs WholeMilliseconds(TimeNs time_ns) {
  const TimeNs rest_ns = time_ns % kNsPerMs;
  return time_ns - rest_ns - (rest_ns < 0 ? kNsPerMs : 0);
}

// Adds the rows, and each sender that is heard as a transmitter. Phones stamp in whole
// milliseconds.
void AddRows(const std::vector<Sender>& senders, const SenderRows& rows, Recording* recording) {
  std::map<std::size_t, std::uint32_t> transmitter;
  for (const auto& [sender, row] : rows) {
    const auto [found, is_new] =
        transmitter.try_emplace(sender, static_cast<std::uint32_t>(recording->transmitters.size()));
    if (is_new) recording->transmitters.push_back({senders[sender].radio, senders[sender].name});
    RadioRow& added = recording->radio_rows.emplace_back(row);
    added.transmitter = found->second;
    added.printed_ns = WholeMilliseconds(added.printed_ns);
    added.heard_ns = WholeMilliseconds(added.heard_ns);
  }
}

}  // namespace

void SimulateWifi(const Plan& plan, const std::vector<Sender>& access_points,
                  const std::vector<WalkState>& states, const SimulationSettings& settings,
                  Random* random, Recording* recording) {
  const WifiSettings& wifi = settings.wifi;
  const double offset_db = random->Fork(kDeviceOffset).Normal(0.0, wifi.device_offset_sigma_db);
  std::map<std::size_t, Heard> memory;  // by access point
  SenderRows rows;
  const TimeNs begin_ns = states.front().time_ns;
  const TimeNs end_ns = states.back().time_ns;
  const TimeNs latency_ns = DurationNs(wifi.latency_s);
  TimeNs sweep_ns = begin_ns - DurationNs(wifi.run_up_s);
  while (true) {
    const double duration_s = random->Uniform(wifi.shortest_sweep_s, wifi.longest_sweep_s);
    const TimeNs printed_ns = sweep_ns + DurationNs(duration_s);
    if (printed_ns > end_ns) break;
    for (std::size_t i = 0; i < access_points.size(); ++i) {
      const TimeNs heard_ns = sweep_ns + DurationNs(duration_s * access_points[i].phase);
      const double rssi_dbm =
          offset_db + DrawRssiDbm(plan, access_points[i], StateAt(states, heard_ns),
                                  settings.propagation, random);
      const bool refreshed = random->Uniform() >= 1.0 - RefreshShare(wifi, rssi_dbm);
      if (refreshed && rssi_dbm >= wifi.threshold_dbm) {
        memory[i] = {heard_ns - latency_ns, std::round(rssi_dbm)};
      }
    }
    if (printed_ns >= begin_ns) PrintScan(printed_ns, memory, wifi.keep_s, &rows);
    sweep_ns = printed_ns;
  }
  AddRows(access_points, rows, recording);
}

void SimulateBeacons(const Plan& plan, const std::vector<Sender>& beacons,
                     const std::vector<WalkState>& states, const SimulationSettings& settings,
                     Random* random, Recording* recording) {
  // The core specification delays every advertisement by up to 10 ms, so that two beacons do not
  // collide for ever.
  constexpr double kLongestDelayS = 0.01;
  const BeaconSettings& beacon = settings.beacon;
  const double offset_db = random->Fork(kDeviceOffset).Normal(0.0, beacon.device_offset_sigma_db);
  SenderRows rows;
  for (std::size_t i = 0; i < beacons.size(); ++i) {
    TimeNs time_ns = states.front().time_ns + DurationNs(beacons[i].phase * beacon.interval_s);
    while (time_ns <= states.back().time_ns) {
      const double rssi_dbm = offset_db + DrawRssiDbm(plan, beacons[i], StateAt(states, time_ns),
                                                      settings.propagation, random);
      const bool lost = random->Uniform() < beacon.loss;
      if (!lost && rssi_dbm >= beacon.threshold_dbm) {
        RadioRow row;
        row.printed_ns = row.heard_ns = time_ns;
        row.rssi_dbm = static_cast<float>(std::round(rssi_dbm));
        rows.emplace_back(i, row);
      }
      time_ns += DurationNs(beacon.interval_s + random->Uniform(0.0, kLongestDelayS));
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
    return a.second.printed_ns < b.second.printed_ns;
  });
  AddRows(beacons, rows, recording);
}

}  // namespace walkgraph
