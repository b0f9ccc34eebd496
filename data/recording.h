#ifndef WALKGRAPH_DATA_RECORDING_H_
#define WALKGRAPH_DATA_RECORDING_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "data/time.h"

namespace walkgraph {

// Samples of one sensor in order of time; readers guarantee strictly increasing times and finite
// values (what they had to drop is counted in the ReadReport).
template <typename T>
struct Stream {
  std::vector<TimeNs> time_ns;
  std::vector<T> value;

  std::size_t size() const { return time_ns.size(); }
  bool empty() const { return time_ns.empty(); }
  void push_back(TimeNs time, const T& sample) {
    time_ns.push_back(time);
    value.push_back(sample);
  }
};

enum class Radio : std::uint8_t { kWifi = 0, kBeacon = 1, kZigbee = 2 };
inline constexpr int kRadioCount = 3;
inline constexpr std::array<Radio, kRadioCount> kAllRadios = {Radio::kWifi, Radio::kBeacon,
                                                              Radio::kZigbee};
inline const char* RadioName(Radio radio) {
  constexpr const char* kNames[] = {"wifi", "beacon", "zigbee"};
  return kNames[static_cast<int>(radio)];
}

// What sends: an access point's BSSID, or a beacon's "uuid_major_minor_mac" (in GetSensorData logs
// its MAC address alone, for some lack the identifiers), all in lower case; of other radios a name.
struct Transmitter {
  Radio radio = Radio::kWifi;
  std::string name;
  bool operator==(const Transmitter&) const = default;
  auto operator<=>(const Transmitter&) const = default;
};

// One printed row of a Wi-Fi scan or beacon report, repeats included: making each reading count
// once is the frontend's work.
struct RadioRow {
  TimeNs printed_ns = 0;  // when the recorder wrote it: rows of one scan share it
  TimeNs heard_ns = 0;  // when the phone last heard the transmitter; printed_ns where not recorded
  std::uint32_t transmitter = 0;  // index into Recording::transmitters
  float rssi_dbm = 0;
};

// The sensor streams of one walk and nothing else: no truth, no building. Device axes are Android's
// (x right, y up along the screen, z out of it). Readers live in data/formats/.
struct Recording {
  std::string id;       // path relative to the dataset, without extension, '/' as "__"
  std::string device;   // phone model, empty where unknown
  TimeNs begin_ns = 0;  // first sample of any stream or radio row
  TimeNs end_ns = 0;    // last sample of any stream or radio row
  // Unix time of begin_ns, to minutes: what two recordings' clocks are compared by. None where
  // neither the stamps nor the file tell.
  std::optional<TimeNs> begin_unix_ns;

  Stream<Eigen::Vector3d> accelerometer_mps2;  // specific force, device axes
  Stream<Eigen::Vector3d> gyroscope_radps;     // device axes, as calibrated by the phone
  Stream<Eigen::Vector3d> magnetometer_ut;  // microtesla, device axes, as calibrated by the phone
  Stream<Eigen::Quaterniond> rotation_vector;  // device to east-north-up (magnetic north)
  Stream<double> pressure_hpa;

  std::vector<Transmitter> transmitters;  // each once
  std::vector<RadioRow> radio_rows;       // by printed_ns, then in file order
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_RECORDING_H_
