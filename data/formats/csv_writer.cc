#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "data/formats/csv.h"
#include "data/formats/csv_files.h"
#include "data/formats/text_output.h"

namespace walkgraph {
namespace {

namespace fs = std::filesystem;

constexpr int kWgs84Decimals = 9;  // a tenth of a millimetre

// A table that is built in memory and written at once.
class CsvTable {
 public:
  explicit CsvTable(const std::string& header) : text_(header + "\n") {}

  void Add(const TextRow& row) { text_.append(row.text()).append("\n"); }
  void Write(const fs::path& path) const { WriteTextFile(path.string(), text_); }

 private:
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
  CsvTable Table(const char* columns) const { return CsvTable(std::string("time_s,") + columns); }
  TextRow Row(TimeNs time_ns) const { return TextRow(',').Seconds(time_ns, precision_.time_s); }

  CsvPrecision precision_;
  fs::path folder_;
};

void CsvWriter::WriteVectors(const Stream<Eigen::Vector3d>& stream, int decimals,
                             const char* columns, const char* file) const {
  if (stream.empty()) return;
  CsvTable table = Table(columns);
  for (std::size_t i = 0; i < stream.size(); ++i) {
    TextRow row = Row(stream.time_ns[i]);
    for (const double component : stream.value[i]) row.Number(component, decimals);
    table.Add(row);
  }
  table.Write(folder_ / file);
}

void CsvWriter::WriteRotations(const Stream<Eigen::Quaterniond>& stream) const {
  if (stream.empty()) return;
  CsvTable table = Table(csv::kRotationVectorColumns);
  for (std::size_t i = 0; i < stream.size(); ++i) {
    TextRow row = Row(stream.time_ns[i]);
    const Eigen::Vector4d& xyzw = stream.value[i].coeffs();
    for (const double component : xyzw) row.Number(component, precision_.quaternion);
    table.Add(row);
  }
  table.Write(folder_ / csv::kRotationVectorFile);
}

void CsvWriter::WritePressure(const Stream<double>& stream) const {
  if (stream.empty()) return;
  CsvTable table = Table(csv::kPressureColumns);
  for (std::size_t i = 0; i < stream.size(); ++i) {
    table.Add(Row(stream.time_ns[i]).Number(stream.value[i], precision_.pressure_hpa));
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
    table.Add(Row(row.printed_ns)
                  .Seconds(row.heard_ns, precision_.time_s)
                  .Text(transmitter.name)
                  .Number(row.rssi_dbm, precision_.rssi_dbm));
  }
  if (any) table.Write(folder_ / file);
}

void CsvWriter::WriteWaypoints(const Truth& truth) const {
  if (truth.waypoints.empty()) return;
  const bool wgs84 = truth.frame == TruthFrame::kWgs84;
  const int decimals = wgs84 ? kWgs84Decimals : precision_.waypoint;
  CsvTable table = Table(wgs84 ? csv::kWgs84WaypointColumns : csv::kWaypointColumns);
  for (const Waypoint& waypoint : truth.waypoints) {
    TextRow row = Row(waypoint.time_ns);
    for (const double component : waypoint.position) row.Number(component, decimals);
    table.Add(row.Text(std::to_string(waypoint.floor)));
  }
  table.Write(folder_ / csv::kWaypointFile);
}

constexpr int kPathDecimals = 4;

}  // namespace

void WritePathCsv(const std::vector<PathPoint>& path, const std::string& file) {
  CsvTable table(csv::kPathHeader);
  for (const PathPoint& point : path) {
    TextRow row(',');
    row.Text(std::to_string(point.time_ns));
    for (const double component : point.position_m) row.Number(component, kPathDecimals);
    table.Add(row.Text(std::to_string(point.floor)).Number(point.heading_rad, kPathDecimals));
  }
  table.Write(file);
}

void WriteCsvWalk(const Recording& recording, const Truth& truth, const CsvPrecision& precision,
                  const std::string& folder) {
  MakeFolder(folder);
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
    WriteTextFile((fs::path(folder) / csv::kWalkFile).string(), walk.dump() + "\n");
  }
}

}  // namespace walkgraph
