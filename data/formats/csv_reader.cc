#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "data/formats/csv.h"
#include "data/formats/csv_files.h"
#include "data/formats/record_counter.h"
#include "data/formats/recording_builder.h"
#include "data/formats/text_input.h"
#include "data/input_error.h"

namespace walkgraph {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFiles = {
    csv::kAccelerometerFile, csv::kGyroscopeFile, csv::kMagnetometerFile, csv::kRotationVectorFile,
    csv::kPressureFile,      csv::kWifiFile,      csv::kBeaconFile,       csv::kWaypointFile};

constexpr double kHighestFloor = 1000;

using ParseTime = bool (*)(std::string_view, TimeNs*);

// The last number of a row: whatever follows it makes the row malformed.
bool ParseLastDouble(FieldReader* fields, double* value) {
  return ParseDouble(fields->Next(), value) && fields->exhausted();
}

class CsvReader {
 public:
  CsvReader(std::string folder, ReadReport* report)
      : folder_(std::move(folder)), report_(report), builder_(report) {}

  void Read(Walk* walk);

 private:
  using AddVector = void (RecordingBuilder::*)(TimeNs, const Eigen::Vector3d&);

  // Calls `read_row(time, fields)` for each row behind the header; it returns false, and has added
  // nothing, where the row is malformed. Every row begins with the `time_columns`, given without
  // their unit. A file that does not exist is no error: nobody has every sensor.
  template <typename ReadRow>
  void ReadFile(const char* name, std::string_view time_columns, std::string_view columns,
                const ReadRow& read_row);

  void ReadVectors(const char* name, std::string_view columns, AddVector add);
  void ReadRotationVector();
  void ReadPressure();
  void ReadRadio(const char* name, std::string_view columns, Radio radio);
  TruthFrame ReadWaypoints();

  std::string folder_;
  ReadReport* report_;
  RecordingBuilder builder_;
  ParseTime parse_time_ = nullptr;  // of the file that is being read
};

std::string Header(std::string_view time_columns, std::string_view unit, std::string_view columns) {
  std::string header;
  FieldReader names(time_columns, ',');
  while (!names.exhausted()) header.append(names.Next()).append(unit).append(",");
  return header.append(columns);
}

// The parser for the unit of time that the header names.
ParseTime CheckHeader(const std::string& path, std::string_view header,
                      std::string_view time_columns, std::string_view columns) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (header.starts_with(kByteOrderMark)) header.remove_prefix(kByteOrderMark.size());
  const std::string in_ns = Header(time_columns, "_ns", columns);
  const std::string in_s = Header(time_columns, "_s", columns);
  if (header == in_ns) return ParseNanosecondsNs;
  if (header == in_s) return ParseSecondsNs;
  constexpr std::size_t kShown = 200;
  throw InputError(path, 1, "header '" + std::string(header.substr(0, kShown)) + "'",
                   "'" + in_ns + "' or '" + in_s + "'");
}

template <typename ReadRow>
void CsvReader::ReadFile(const char* name, std::string_view time_columns, std::string_view columns,
                         const ReadRow& read_row) {
  const std::string path = (fs::path(folder_) / name).string();
  if (!fs::is_regular_file(path)) return;
  const std::string text = ReadFileBytes(path);
  report_->bytes += static_cast<std::int64_t>(text.size());
  LineReader lines(text);
  std::string_view line;
  lines.Next(&line);
  parse_time_ = CheckHeader(path, line, time_columns, columns);
  std::int64_t rows = 0;
  while (lines.Next(&line)) {
    if (line.empty()) continue;
    ++rows;
    FieldReader fields(line, ',');
    TimeNs time = 0;
    if (!lines.terminated()) {
      CountCutLine(report_);
    } else if (!parse_time_(fields.Next(), &time) || !read_row(time, &fields)) {
      CountMalformed(lines.number(), report_);
    }
  }
  report_->records[name] = rows;
  report_->lines += lines.number();
}

void CsvReader::ReadVectors(const char* name, std::string_view columns, AddVector add) {
  ReadFile(name, "time", columns, [&](TimeNs time, FieldReader* fields) {
    Eigen::Vector3d vector;
    if (!ParseDouble(fields->Next(), &vector.x()) || !ParseDouble(fields->Next(), &vector.y()) ||
        !ParseLastDouble(fields, &vector.z())) {
      return false;
    }
    (builder_.*add)(time, vector);
    return true;
  });
}

void CsvReader::ReadRotationVector() {
  const auto read_row = [&](TimeNs time, FieldReader* fields) {
    Eigen::Quaterniond rotation;
    if (!ParseDouble(fields->Next(), &rotation.x()) ||
        !ParseDouble(fields->Next(), &rotation.y()) ||
        !ParseDouble(fields->Next(), &rotation.z()) || !ParseLastDouble(fields, &rotation.w())) {
      return false;
    }
    builder_.AddQuaternion(time, rotation);
    return true;
  };
  ReadFile(csv::kRotationVectorFile, "time", csv::kRotationVectorColumns, read_row);
}

void CsvReader::ReadPressure() {
  const auto read_row = [&](TimeNs time, FieldReader* fields) {
    double hpa = 0;
    if (!ParseLastDouble(fields, &hpa)) return false;
    builder_.AddPressure(time, hpa);
    return true;
  };
  ReadFile(csv::kPressureFile, "time", csv::kPressureColumns, read_row);
}

void CsvReader::ReadRadio(const char* name, std::string_view columns, Radio radio) {
  ReadFile(name, "time,heard", columns, [&](TimeNs time, FieldReader* fields) {
    TimeNs heard = 0;
    double rssi_dbm = 0;
    if (!parse_time_(fields->Next(), &heard)) return false;
    const std::string_view transmitter = fields->Next();
    if (transmitter.empty() || !ParseLastDouble(fields, &rssi_dbm)) return false;
    builder_.AddRadioRow(radio, transmitter, time, heard, rssi_dbm);
    return true;
  });
}

TruthFrame CsvReader::ReadWaypoints() {
  constexpr std::size_t kHeaderBytes = 200;
  const std::string path = (fs::path(folder_) / csv::kWaypointFile).string();
  const std::string beginning = ReadFileBeginning(path, kHeaderBytes);
  const bool wgs84 = beginning.find(csv::kWgs84WaypointColumns) != std::string::npos;
  const char* columns = wgs84 ? csv::kWgs84WaypointColumns : csv::kWaypointColumns;
  ReadFile(csv::kWaypointFile, "time", columns, [&](TimeNs time, FieldReader* fields) {
    Eigen::Vector2d position;
    double floor = 0;
    if (!ParseDouble(fields->Next(), &position.x()) ||
        !ParseDouble(fields->Next(), &position.y()) || !ParseLastDouble(fields, &floor) ||
        !(std::abs(floor) <= kHighestFloor)) {
      return false;
    }
    builder_.AddWaypoint(time, position, static_cast<int>(floor));
    return true;
  });
  return wgs84 ? TruthFrame::kWgs84 : TruthFrame::kBuilding;
}

nlohmann::json ReadWalkJson(const std::string& folder) {
  const std::string path = (fs::path(folder) / csv::kWalkFile).string();
  if (!fs::is_regular_file(path)) return nlohmann::json::object();
  auto document = nlohmann::json::parse(ReadFileBytes(path), nullptr, false);
  if (!document.is_object()) throw InputError(path, 0, "malformed JSON", "an object");
  return document;
}

// The text under a key; empty where it is missing.
std::string TextOf(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

void CsvReader::Read(Walk* walk) {
  ReadVectors(csv::kAccelerometerFile, csv::kAccelerometerColumns,
              &RecordingBuilder::AddAcceleration);
  ReadVectors(csv::kGyroscopeFile, csv::kGyroscopeColumns, &RecordingBuilder::AddAngularRate);
  ReadVectors(csv::kMagnetometerFile, csv::kMagnetometerColumns,
              &RecordingBuilder::AddMagneticField);
  ReadRotationVector();
  ReadPressure();
  ReadRadio(csv::kWifiFile, csv::kWifiColumns, Radio::kWifi);
  ReadRadio(csv::kBeaconFile, csv::kBeaconColumns, Radio::kBeacon);
  const TruthFrame frame = ReadWaypoints();
  builder_.Finish(&walk->recording, &walk->truth);
  walk->truth.frame = frame;
  walk->recording.device = TextOf(ReadWalkJson(folder_), "device");
}

bool ParsePathPoint(FieldReader fields, PathPoint* point) {
  double floor = 0;
  if (!ParseNanosecondsNs(fields.Next(), &point->time_ns)) return false;
  for (double& component : point->position_m) {
    if (!ParseDouble(fields.Next(), &component)) return false;
  }
  if (!ParseDouble(fields.Next(), &floor) || !(std::abs(floor) <= kHighestFloor)) return false;
  point->floor = static_cast<int>(floor);
  return ParseLastDouble(&fields, &point->heading_rad);
}

}  // namespace

std::vector<PathPoint> ReadPathCsv(const std::string& file) {
  const std::string text = ReadFileBytes(file);
  LineReader lines(text);
  std::string_view line;
  lines.Next(&line);
  if (line != csv::kPathHeader) {
    throw InputError(file, 1, "another header", std::string("'") + csv::kPathHeader + "'");
  }
  std::vector<PathPoint> path;
  while (lines.Next(&line)) {
    if (!ParsePathPoint(FieldReader(line, ','), &path.emplace_back())) {
      throw InputError(file, lines.number(), "malformed row", csv::kPathHeader);
    }
  }
  return path;
}

bool IsCsvWalk(const std::string& folder) {
  return std::any_of(kFiles.begin(), kFiles.end(), [&folder](const char* file) {
    return fs::is_regular_file(fs::path(folder) / file);
  });
}

Walk ReadCsvWalk(const std::string& folder) {
  Walk walk;
  walk.report.format = "csv";
  CsvReader(folder, &walk.report).Read(&walk);
  return walk;
}

std::string ReadCsvTrial(const std::string& folder) {
  return TextOf(ReadWalkJson(folder), "trial");
}

}  // namespace walkgraph
