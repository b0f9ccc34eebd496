#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "data/formats/csv.h"
#include "data/formats/csv_files.h"
#include "data/input_error.h"

namespace walkgraph {
namespace {

namespace fs = std::filesystem;

constexpr int kWgs84Decimals = 9;  // a tenth of a millimetre

void WriteWholeFile(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file) throw InputError(path.string(), 0, "cannot be written", "a writable folder");
}

// A table that is built in memory and written at once.
class CsvTable {
 public:
  CsvTable(int time_decimals, const std::string& header)
      : time_decimals_(time_decimals), text_(header + "\n") {}

  // Times are cut to the precision: rounding could put a reading after its own row.
  CsvTable& Time(TimeNs time_ns) {
    TimeNs unit_ns = kNsPerSecond;
    for (int i = 0; i < time_decimals_; ++i) unit_ns /= 10;
    const bool negative = time_ns < 0;
    const TimeNs units = (negative ? -time_ns : time_ns) / unit_ns;
    std::string digits = std::to_string(units);
    const auto decimals = static_cast<std::size_t>(time_decimals_);
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    if (decimals > 0) digits.insert(digits.size() - decimals, 1, '.');
    return Text(negative ? "-" + digits : digits);
  }

  // Fixed decimals; "-0.00" is written as "0.00".
  CsvTable& Number(double value, int decimals) {
    char buffer[std::numeric_limits<double>::max_exponent10 + 64];
    const auto result =
        std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::fixed, decimals);
    std::string digits(buffer, result.ptr);
    if (digits.front() == '-' && digits.find_first_not_of("-0.") == std::string::npos) {
      digits.erase(0, 1);
    }
    return Text(digits);
  }

  CsvTable& Text(const std::string& field) {
    if (text_.back() != '\n') text_ += ',';
    text_ += field;
    return *this;
  }

  void EndRow() { text_ += '\n'; }

  void Write(const fs::path& path) const { WriteWholeFile(path, text_); }

 private:
  int time_decimals_;
  std::string text_;
};

class CsvWriter {
 public:
  CsvWriter(const CsvPrecision& precision, fs::path folder)
      : precision_(precision), folder_(std::move(folder)) {}

  void WriteVectors(const Stream<Eigen::Vector3d>& stream, int decimals, const char* columns,
                    const char* file) const;
  void WriteRotations(const Stream<Eigen::Quaterniond>& stream) const;
  void WritePressure(const Stream<double>& stream) const;
  void WriteRadio(const Recording& recording, Radio radio, const char* columns,
                  const char* file) const;
  void WriteWaypoints(const Truth& truth) const;

 private:
  CsvTable Table(const char* columns) const {
    return {precision_.time_s, std::string("time_s,") + columns};
  }

  CsvPrecision precision_;
  fs::path folder_;
};

void CsvWriter::WriteVectors(const Stream<Eigen::Vector3d>& stream, int decimals,
                             const char* columns, const char* file) const {
  if (stream.empty()) return;
  CsvTable table = Table(columns);
  for (std::size_t i = 0; i < stream.size(); ++i) {
    table.Time(stream.time_ns[i]);
    for (const double component : stream.value[i]) table.Number(component, decimals);
    table.EndRow();
  }
  table.Write(folder_ / file);
}

void CsvWriter::WriteRotations(const Stream<Eigen::Quaterniond>& stream) const {
  if (stream.empty()) return;
  CsvTable table = Table(csv::kRotationVectorColumns);
  for (std::size_t i = 0; i < stream.size(); ++i) {
    table.Time(stream.time_ns[i]);
    const Eigen::Vector4d& xyzw = stream.value[i].coeffs();
    for (const double component : xyzw) table.Number(component, precision_.quaternion);
    table.EndRow();
  }
  table.Write(folder_ / csv::kRotationVectorFile);
}

void CsvWriter::WritePressure(const Stream<double>& stream) const {
  if (stream.empty()) return;
  CsvTable table = Table(csv::kPressureColumns);
  for (std::size_t i = 0; i < stream.size(); ++i) {
    table.Time(stream.time_ns[i]).Number(stream.value[i], precision_.pressure_hpa).EndRow();
  }
  table.Write(folder_ / csv::kPressureFile);
}

void CsvWriter::WriteRadio(const Recording& recording, Radio radio, const char* columns,
                           const char* file) const {
  CsvTable table = Table((std::string("heard_s,") + columns).c_str());
  bool any = false;
  for (const RadioRow& row : recording.radio_rows) {
    const Transmitter& transmitter = recording.transmitters.at(row.transmitter);
    if (transmitter.radio != radio) continue;
    any = true;
    table.Time(row.printed_ns).Time(row.heard_ns).Text(transmitter.name);
    table.Number(row.rssi_dbm, precision_.rssi_dbm).EndRow();
  }
  if (any) table.Write(folder_ / file);
}

void CsvWriter::WriteWaypoints(const Truth& truth) const {
  if (truth.waypoints.empty()) return;
  const bool wgs84 = truth.frame == TruthFrame::kWgs84;
  const int decimals = wgs84 ? kWgs84Decimals : precision_.waypoint;
  CsvTable table = Table(wgs84 ? csv::kWgs84WaypointColumns : csv::kWaypointColumns);
  for (const Waypoint& waypoint : truth.waypoints) {
    table.Time(waypoint.time_ns);
    for (const double component : waypoint.position) table.Number(component, decimals);
    table.Text(std::to_string(waypoint.floor)).EndRow();
  }
  table.Write(folder_ / csv::kWaypointFile);
}

constexpr int kPathDecimals = 4;

}  // namespace

void WritePathCsv(const std::vector<PathPoint>& path, const std::string& file) {
  CsvTable table(0, csv::kPathHeader);
  for (const PathPoint& point : path) {
    table.Text(std::to_string(point.time_ns));
    for (const double component : point.position_m) table.Number(component, kPathDecimals);
    table.Text(std::to_string(point.floor)).Number(point.heading_rad, kPathDecimals).EndRow();
  }
  table.Write(file);
}

void WriteCsvWalk(const Recording& recording, const Truth& truth, const CsvPrecision& precision,
                  const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder, 0, error.message(), "a folder that can be made");
  const CsvWriter writer(precision, folder);
  writer.WriteVectors(recording.accelerometer_mps2, precision.acceleration_mps2,
                      csv::kAccelerometerColumns, csv::kAccelerometerFile);
  writer.WriteVectors(recording.gyroscope_radps, precision.angular_rate_radps,
                      csv::kGyroscopeColumns, csv::kGyroscopeFile);
  writer.WriteVectors(recording.magnetometer_ut, precision.magnetic_field_ut,
                      csv::kMagnetometerColumns, csv::kMagnetometerFile);
  writer.WriteRotations(recording.rotation_vector);
  writer.WritePressure(recording.pressure_hpa);
  writer.WriteRadio(recording, Radio::kWifi, csv::kWifiColumns, csv::kWifiFile);
  writer.WriteRadio(recording, Radio::kBeacon, csv::kBeaconColumns, csv::kBeaconFile);
  writer.WriteWaypoints(truth);
  if (!recording.device.empty()) {
    const nlohmann::json walk = {{"device", recording.device}};
    WriteWholeFile(fs::path(folder) / csv::kWalkFile, walk.dump() + "\n");
  }
}

}  // namespace walkgraph
