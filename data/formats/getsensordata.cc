#include "data/formats/getsensordata.h"

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <vector>

#include "data/formats/java_date.h"
#include "data/formats/record_counter.h"
#include "data/formats/recording_builder.h"
#include "data/formats/sensor_clock.h"
#include "data/formats/text_input.h"

namespace walkgraph {
namespace {

// Samples wait here until the whole sensor is read and its clock is known.
template <typename T>
struct SensorSamples {
  TwoClocks clocks;
  std::vector<T> value;
};

// Rows wait too, because a Wi-Fi row's sensor time means something only with the clock.
struct PendingRow {
  Radio radio = Radio::kWifi;
  std::string_view name;
  TimeNs printed_ns = 0;
  std::optional<TimeNs> sensor_ns;
  double rssi_dbm = 0;
};

// Wi-Fi is stamped by the driver and the accelerometer by its hub: beyond this the stamps disagree,
// below it a reading from after its own row is rounding.
constexpr TimeNs kWifiClockToleranceNs = kNsPerSecond / 10;

class GetSensorDataReader {
 public:
  explicit GetSensorDataReader(ReadReport* report) : report_(report), builder_(report) {}

  void Read(std::string_view text, Walk* walk);

 private:
  void ReadHeader(std::string_view line);
  // False where the line is malformed.
  bool ReadRecord(std::string_view line);
  bool ReadVector(TimeNs time, FieldReader fields, SensorSamples<Eigen::Vector3d>* samples);
  bool ReadOrientation(TimeNs time, FieldReader fields);
  bool ReadPressure(TimeNs time, FieldReader fields);
  bool ReadWifi(TimeNs time, std::string_view values);
  bool ReadBle(TimeNs time, FieldReader fields);
  bool ReadPosition(TimeNs time, FieldReader fields);
  void AlignClocks();
  void AddRadioRows();

  ReadReport* report_;
  RecordingBuilder builder_;
  RecordCounter counter_;
  std::string device_;
  std::optional<TimeNs> created_ns_;  // Unix time
  SensorSamples<Eigen::Vector3d> acceleration_;
  SensorSamples<Eigen::Vector3d> angular_rate_;
  SensorSamples<Eigen::Vector3d> magnetic_field_;
  SensorSamples<Eigen::Vector3d> orientation_;
  SensorSamples<double> pressure_;
  std::vector<PendingRow> radio_rows_;
};

bool ParseVector(FieldReader* fields, Eigen::Vector3d* vector) {
  return ParseDouble(fields->Next(), &vector->x()) && ParseDouble(fields->Next(), &vector->y()) &&
         ParseDouble(fields->Next(), &vector->z());
}

std::string_view Trim(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

void GetSensorDataReader::ReadHeader(std::string_view line) {
  constexpr std::string_view kModel = "% Model:", kCreated = "% Date of creation:";
  if (line.starts_with(kModel)) device_ = Trim(line.substr(kModel.size()));
  if (line.starts_with(kCreated)) created_ns_ = ParseJavaDate(Trim(line.substr(kCreated.size())));
}

bool GetSensorDataReader::ReadVector(TimeNs time, FieldReader fields,
                                     SensorSamples<Eigen::Vector3d>* samples) {
  TimeNs sensor_time = 0;
  Eigen::Vector3d vector;
  if (!ParseSecondsNs(fields.Next(), &sensor_time) || !ParseVector(&fields, &vector)) return false;
  samples->clocks.push_back(time, sensor_time);
  samples->value.push_back(vector);
  return true;
}

bool GetSensorDataReader::ReadOrientation(TimeNs time, FieldReader fields) {
  TimeNs sensor_time = 0;
  if (!ParseSecondsNs(fields.Next(), &sensor_time)) return false;
  for (int angle = 0; angle < 3; ++angle) fields.Next();  // the same rotation as Euler angles
  Eigen::Vector3d vector;
  if (!ParseVector(&fields, &vector)) return false;
  orientation_.clocks.push_back(time, sensor_time);
  orientation_.value.push_back(vector);
  return true;
}

bool GetSensorDataReader::ReadPressure(TimeNs time, FieldReader fields) {
  TimeNs sensor_time = 0;
  double hpa = 0;
  if (!ParseSecondsNs(fields.Next(), &sensor_time) || !ParseDouble(fields.Next(), &hpa)) {
    return false;
  }
  pressure_.clocks.push_back(time, sensor_time);
  pressure_.value.push_back(hpa);
  return true;
}

bool GetSensorDataReader::ReadWifi(TimeNs time, std::string_view values) {
  // From the right, because an SSID may hold anything. A row may end in a separator.
  if (values.ends_with(';')) values.remove_suffix(1);
  PendingRow row;
  row.printed_ns = time;
  const std::string_view rssi = TakeLastField(&values, ';');
  TakeLastField(&values, ';');  // frequency
  row.name = TakeLastField(&values, ';');
  if (row.name.empty() || !ParseDouble(rssi, &row.rssi_dbm)) return false;
  FieldReader fields(values, ';');
  if (!ParseSecondsNs(fields.Next(), &row.sensor_ns.emplace())) return false;
  if (fields.Rest().find(';') != std::string_view::npos) ++report_->hazards["separator_in_ssid"];
  radio_rows_.push_back(row);
  return true;
}

bool GetSensorDataReader::ReadBle(TimeNs time, FieldReader fields) {
  fields.Next();  // iBeacon or Eddystone
  PendingRow row;
  row.radio = Radio::kBeacon;
  row.printed_ns = time;
  row.name = fields.Next();
  if (row.name.empty() || !ParseDouble(fields.Next(), &row.rssi_dbm)) return false;
  radio_rows_.push_back(row);
  return true;
}

bool GetSensorDataReader::ReadPosition(TimeNs time, FieldReader fields) {
  fields.Next();  // counter
  double latitude_deg = 0;
  double longitude_deg = 0;
  double floor = 0;
  if (!ParseDouble(fields.Next(), &latitude_deg) || !ParseDouble(fields.Next(), &longitude_deg) ||
      !ParseDouble(fields.Next(), &floor)) {
    return false;
  }
  constexpr double kHighestFloor = 1000;
  if (!(std::abs(floor) <= kHighestFloor)) return false;
  builder_.AddWaypoint(time, {latitude_deg, longitude_deg}, static_cast<int>(floor));
  return true;
}

bool GetSensorDataReader::ReadRecord(std::string_view line) {
  FieldReader fields(line, ';');
  const std::string_view type = fields.Next();
  TimeNs time = 0;
  if (type.size() != 4 || !ParseSecondsNs(fields.Next(), &time)) return false;
  counter_.Count(type);
  if (type == "ACCE") return ReadVector(time, fields, &acceleration_);
  if (type == "GYRO") return ReadVector(time, fields, &angular_rate_);
  if (type == "MAGN") return ReadVector(time, fields, &magnetic_field_);
  if (type == "AHRS") return ReadOrientation(time, fields);
  if (type == "PRES") return ReadPressure(time, fields);
  if (type == "WIFI") return ReadWifi(time, fields.Rest());
  if (type == "BLE4") return ReadBle(time, fields);
  if (type == "POSI") return ReadPosition(time, fields);
  return true;
}

void GetSensorDataReader::AlignClocks() {
  const auto add = [this](const auto& samples, auto method) {
    const std::vector<TimeNs> time_ns = AlignToApplication(samples.clocks, report_);
    for (std::size_t i = 0; i < time_ns.size(); ++i) {
      (builder_.*method)(time_ns[i], samples.value[i]);
    }
  };
  add(acceleration_, &RecordingBuilder::AddAcceleration);
  add(angular_rate_, &RecordingBuilder::AddAngularRate);
  add(magnetic_field_, &RecordingBuilder::AddMagneticField);
  add(orientation_, &RecordingBuilder::AddRotationVector);
  add(pressure_, &RecordingBuilder::AddPressure);
}

void GetSensorDataReader::AddRadioRows() {
  const std::optional<TimeNs> offset = ClockOffset(acceleration_.clocks);
  for (const PendingRow& row : radio_rows_) {
    TimeNs heard = row.printed_ns;
    if (row.sensor_ns && offset) heard = *row.sensor_ns + *offset;
    if (heard > row.printed_ns && heard - row.printed_ns <= kWifiClockToleranceNs) {
      heard = row.printed_ns;
    }
    builder_.AddRadioRow(row.radio, row.name, row.printed_ns, heard, row.rssi_dbm);
  }
}

void GetSensorDataReader::Read(std::string_view text, Walk* walk) {
  LineReader lines(text);
  std::string_view line;
  while (lines.Next(&line)) {
    if (line.empty()) continue;
    if (line.front() == '%') {
      ReadHeader(line);
    } else if (!lines.terminated()) {
      CountCutLine(report_);
    } else if (!ReadRecord(line)) {
      CountMalformed(lines.number(), report_);
    }
  }
  report_->lines = lines.number();
  counter_.AddTo(&report_->records);
  AlignClocks();
  AddRadioRows();
  builder_.Finish(&walk->recording, &walk->truth);
  walk->truth.frame = TruthFrame::kWgs84;
  walk->recording.device = device_;
  // AppTimestamp counts from about then.
  if (created_ns_) walk->recording.begin_unix_ns = *created_ns_ + walk->recording.begin_ns;
}

bool LooksLikeRecord(std::string_view line) {
  FieldReader fields(line, ';');
  const std::string_view type = fields.Next();
  TimeNs time = 0;
  const auto in_name = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
  return type.size() == 4 && std::all_of(type.begin(), type.end(), in_name) &&
         ParseSecondsNs(fields.Next(), &time) && !fields.exhausted();
}

}  // namespace

bool LooksLikeGetSensorData(std::string_view beginning) {
  LineReader lines(beginning);
  std::string_view line;
  while (lines.Next(&line)) {
    if (line.starts_with('%') && line.find("GetSensorData") != std::string_view::npos) return true;
    if (LooksLikeRecord(line)) return true;
  }
  return false;
}

std::string GetSensorDataTrial(const std::string& name) {
  constexpr std::string_view kTrial = "Trial";
  const std::size_t begin = name.find(kTrial);
  if (begin == std::string::npos) return name;
  const std::size_t digits = begin + kTrial.size();
  const std::size_t end = std::min(name.find_first_not_of("0123456789", digits), name.size());
  return end > digits ? name.substr(begin, end - begin) : name;
}

Walk ReadGetSensorData(std::string_view text) {
  Walk walk;
  walk.report.format = "getsensordata";
  walk.report.bytes = static_cast<std::int64_t>(text.size());
  GetSensorDataReader(&walk.report).Read(text, &walk);
  return walk;
}

}  // namespace walkgraph
