#include "data/formats/recording_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "data/formats/time_order.h"

namespace walkgraph {
namespace {

// Readings outside these are broken rows, not measurements. Inertial: several times the full scale
// of any phone sensor (16 g, 2000 deg/s, 4912 uT of the AK09911). Pressure: the range of the
// BMP280. RSSI: -127 and 127 mean "not available" in the Bluetooth core specification (HCI Read
// RSSI) and in Android's WifiInfo; +20 dBm is the largest value that the former defines.
constexpr double kLargestAccelerationMps2 = 1000.0;
constexpr double kLargestAngularRateRadps = 200.0;
constexpr double kLargestMagneticFieldUt = 20000.0;
constexpr double kSmallestPressureHpa = 300.0;
constexpr double kLargestPressureHpa = 1100.0;
constexpr double kSmallestRssiDbm = -126.0;
constexpr double kLargestRssiDbm = 20.0;
// A vector part may exceed one by rounding of its printed digits only.
constexpr double kLargestRotationVectorNorm = 1.001;
constexpr double kQuaternionNormTolerance = 0.02;  // two printed decimals per component
// No recorded walk is that long: a time further off is a broken number.
constexpr TimeNs kLongestWalkNs = 24LL * 3600 * kNsPerSecond;
// Streams that both begin and end this much earlier or later than the accelerometer have another
// clock: sensors of one phone start and stop within a fraction of a second.
constexpr TimeNs kClockToleranceNs = kNsPerSecond;

char LowerCase(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

template <typename T>
void Select(const std::vector<std::uint32_t>& order, std::vector<T>* values) {
  std::vector<T> selected;
  selected.reserve(order.size());
  for (const std::uint32_t i : order) selected.push_back((*values)[i]);
  *values = std::move(selected);
}

template <typename T>
void OrderStream(Stream<T>* stream, ReadReport* report) {
  if (const auto order = OrderByTime(stream->time_ns, EqualTimes::kDrop, report)) {
    Select(*order, &stream->time_ns);
    Select(*order, &stream->value);
  }
}

// Drops what lies further than the longest walk from the middle time.
template <typename T>
void DropStrays(TimeNs middle, Stream<T>* stream, ReadReport* report) {
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < stream->size(); ++i) {
    if (std::llabs(stream->time_ns[i] - middle) <= kLongestWalkNs) near.push_back(i);
  }
  if (near.size() == stream->size()) return;
  report->hazards["stray_time"] += static_cast<std::int64_t>(stream->size() - near.size());
  Select(near, &stream->time_ns);
  Select(near, &stream->value);
}

// Calls `visit` for every sensor stream of a recording.
template <typename Visit>
void ForEachStream(Recording* recording, const Visit& visit) {
  visit(&recording->accelerometer_mps2);
  visit(&recording->gyroscope_radps);
  visit(&recording->magnetometer_ut);
  visit(&recording->rotation_vector);
  visit(&recording->pressure_hpa);
}

}  // namespace

void RecordingBuilder::AddVector(Stream<Eigen::Vector3d>* stream, TimeNs time,
                                 const Eigen::Vector3d& value, double largest) {
  if (!value.allFinite()) {
    ++report_->hazards["non_finite"];
  } else if (value.cwiseAbs().maxCoeff() > largest) {
    ++report_->hazards["out_of_range"];
  } else {
    stream->push_back(time, value);
  }
}

void RecordingBuilder::AddAcceleration(TimeNs time, const Eigen::Vector3d& mps2) {
  AddVector(&recording_.accelerometer_mps2, time, mps2, kLargestAccelerationMps2);
}

void RecordingBuilder::AddAngularRate(TimeNs time, const Eigen::Vector3d& radps) {
  AddVector(&recording_.gyroscope_radps, time, radps, kLargestAngularRateRadps);
}

void RecordingBuilder::AddMagneticField(TimeNs time, const Eigen::Vector3d& ut) {
  AddVector(&recording_.magnetometer_ut, time, ut, kLargestMagneticFieldUt);
}

void RecordingBuilder::AddRotationVector(TimeNs time, const Eigen::Vector3d& xyz) {
  const double squared_norm = xyz.squaredNorm();
  if (!std::isfinite(squared_norm)) {
    ++report_->hazards["non_finite"];
  } else if (squared_norm > kLargestRotationVectorNorm * kLargestRotationVectorNorm) {
    ++report_->hazards["out_of_range"];
  } else {
    const double w = std::sqrt(std::max(0.0, 1.0 - squared_norm));
    Eigen::Quaterniond rotation(w, xyz.x(), xyz.y(), xyz.z());
    rotation.normalize();
    recording_.rotation_vector.push_back(time, rotation);
  }
}

void RecordingBuilder::AddQuaternion(TimeNs time, const Eigen::Quaterniond& device_to_enu) {
  const double norm = device_to_enu.norm();
  if (!std::isfinite(norm)) {
    ++report_->hazards["non_finite"];
  } else if (std::abs(norm - 1.0) > kQuaternionNormTolerance) {
    ++report_->hazards["out_of_range"];
  } else {
    const double sign = device_to_enu.w() < 0 ? -1.0 : 1.0;
    recording_.rotation_vector.push_back(
        time, Eigen::Quaterniond(device_to_enu.coeffs() * (sign / norm)));
  }
}

void RecordingBuilder::AddPressure(TimeNs time, double hpa) {
  if (!std::isfinite(hpa)) {
    ++report_->hazards["non_finite"];
  } else if (hpa < kSmallestPressureHpa || hpa > kLargestPressureHpa) {
    ++report_->hazards["out_of_range"];
  } else {
    recording_.pressure_hpa.push_back(time, hpa);
  }
}

std::uint32_t RecordingBuilder::FindOrAddTransmitter(Radio radio, std::string_view name) {
  lower_case_.assign(name);
  std::transform(lower_case_.begin(), lower_case_.end(), lower_case_.begin(), LowerCase);
  NameIndex& index = names_[static_cast<int>(radio)];
  const auto found = index.find(lower_case_);
  if (found != index.end()) return found->second;
  const auto number = static_cast<std::uint32_t>(recording_.transmitters.size());
  recording_.transmitters.push_back({radio, lower_case_});
  index.emplace(lower_case_, number);
  return number;
}

void RecordingBuilder::AddRadioRow(Radio radio, std::string_view name, TimeNs printed, TimeNs heard,
                                   double rssi_dbm) {
  if (!std::isfinite(rssi_dbm)) {
    ++report_->hazards["non_finite"];
    return;
  }
  if (rssi_dbm < kSmallestRssiDbm || rssi_dbm > kLargestRssiDbm) {
    ++report_->hazards["out_of_range"];
    return;
  }
  if (heard > printed) {
    ++report_->hazards["heard_after_printed"];
    heard = printed;
  } else if (printed - heard > kLongestWalkNs) {
    ++report_->hazards["heard_long_before"];
    heard = printed;
  }
  recording_.radio_rows.push_back(
      {printed, heard, FindOrAddTransmitter(radio, name), static_cast<float>(rssi_dbm)});
}

void RecordingBuilder::AddWaypoint(TimeNs time, const Eigen::Vector2d& position, int floor) {
  if (!position.allFinite()) {
    ++report_->hazards["non_finite"];
  } else {
    truth_.waypoints.push_back({time, position, floor});
  }
}

std::vector<TimeNs> RecordingBuilder::AllTimes() {
  std::vector<TimeNs> times;
  ForEachStream(&recording_, [&times](const auto* stream) {
    times.insert(times.end(), stream->time_ns.begin(), stream->time_ns.end());
  });
  for (const RadioRow& row : recording_.radio_rows) times.push_back(row.printed_ns);
  for (const Waypoint& waypoint : truth_.waypoints) times.push_back(waypoint.time_ns);
  return times;
}

void RecordingBuilder::DropStrayTimes() {
  std::vector<TimeNs> times = AllTimes();
  if (times.empty()) return;
  const auto [low, high] = std::minmax_element(times.begin(), times.end());
  if (*high - *low <= kLongestWalkNs) return;
  const auto middle_at = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle_at, times.end());
  const TimeNs middle = *middle_at;
  ForEachStream(&recording_, [&](auto* stream) { DropStrays(middle, stream, report_); });
  const auto stray = [middle](TimeNs time) { return std::llabs(time - middle) > kLongestWalkNs; };
  const std::size_t dropped =
      std::erase_if(recording_.radio_rows,
                    [&](const RadioRow& row) { return stray(row.printed_ns); }) +
      std::erase_if(truth_.waypoints, [&](const Waypoint& w) { return stray(w.time_ns); });
  if (dropped > 0) report_->hazards["stray_time"] += static_cast<std::int64_t>(dropped);
}

// Each radio is judged alone, like a sensor: a format may hold one radio's rows behind the other's.
void RecordingBuilder::OrderRadioRows() {
  const std::vector<RadioRow>& rows = recording_.radio_rows;
  std::vector<std::uint32_t> kept;
  for (int radio = 0; radio < kRadioCount; ++radio) {
    std::vector<std::uint32_t> members;
    std::vector<TimeNs> printed;
    for (std::uint32_t i = 0; i < rows.size(); ++i) {
      if (recording_.transmitters[rows[i].transmitter].radio != static_cast<Radio>(radio)) continue;
      members.push_back(i);
      printed.push_back(rows[i].printed_ns);
    }
    if (const auto order = OrderByTime(printed, EqualTimes::kKeep, report_)) {
      Select(*order, &members);
    }
    kept.insert(kept.end(), members.begin(), members.end());
  }
  std::sort(kept.begin(), kept.end(), [&rows](std::uint32_t a, std::uint32_t b) {
    return std::pair(rows[a].printed_ns, a) < std::pair(rows[b].printed_ns, b);
  });
  Select(kept, &recording_.radio_rows);
}

void RecordingBuilder::OrderWaypoints() {
  std::vector<TimeNs> times;
  for (const Waypoint& waypoint : truth_.waypoints) times.push_back(waypoint.time_ns);
  if (const auto order = OrderByTime(times, EqualTimes::kDrop, report_)) {
    Select(*order, &truth_.waypoints);
  }
}

void RecordingBuilder::CheckClocks() {
  const std::vector<TimeNs>& reference = recording_.accelerometer_mps2.time_ns;
  if (reference.empty()) return;
  ForEachStream(&recording_, [&](const auto* stream) {
    if (stream->empty()) return;
    const TimeNs begins = stream->time_ns.front() - reference.front();
    const TimeNs ends = stream->time_ns.back() - reference.back();
    if ((begins > kClockToleranceNs && ends > kClockToleranceNs) ||
        (begins < -kClockToleranceNs && ends < -kClockToleranceNs)) {
      ++report_->hazards["clock_disagreement"];
    }
  });
}

void RecordingBuilder::Finish(Recording* recording, Truth* truth) {
  DropStrayTimes();
  ForEachStream(&recording_, [this](auto* stream) { OrderStream(stream, report_); });
  OrderRadioRows();
  OrderWaypoints();
  CheckClocks();

  recording_.begin_ns = std::numeric_limits<TimeNs>::max();
  recording_.end_ns = std::numeric_limits<TimeNs>::min();
  const auto extend = [this](TimeNs first, TimeNs last) {
    recording_.begin_ns = std::min(recording_.begin_ns, first);
    recording_.end_ns = std::max(recording_.end_ns, last);
  };
  ForEachStream(&recording_, [&extend](const auto* stream) {
    if (!stream->empty()) extend(stream->time_ns.front(), stream->time_ns.back());
  });
  if (!recording_.radio_rows.empty()) {
    extend(recording_.radio_rows.front().printed_ns, recording_.radio_rows.back().printed_ns);
  }
  if (recording_.begin_ns > recording_.end_ns) recording_.begin_ns = recording_.end_ns = 0;
  // Clocks that run from the start of the phone or of the app come nowhere near.
  constexpr TimeNs kYear2000 = 946'684'800 * kNsPerSecond;
  if (recording_.begin_ns > kYear2000) recording_.begin_unix_ns = recording_.begin_ns;

  *recording = std::move(recording_);
  *truth = std::move(truth_);
  recording_ = {};
  truth_ = {};
  for (NameIndex& index : names_) index.clear();
}

}  // namespace walkgraph
