#include "data/formats/swiblux.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <utility>
#include <vector>

#include "data/formats/record_counter.h"
#include "data/formats/recording_builder.h"
#include "data/formats/text_input.h"
#include "data/input_error.h"

namespace walkgraph {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHeaderBegin = "x;y;RSSI ";
constexpr std::string_view kAnchorPrefix = "RSSI ";
constexpr char kLimitsFile[] = "Limits.csv";
constexpr double kUnheardDbm = -92;
constexpr double kSamePositionM = 0.01;
constexpr TimeNs kRowNs = 1'000'000'000;
// The route was walked after the survey: were their times the same, a reading of one could pass for
// a reading of the other.
constexpr TimeNs kTestBeginNs = 1'000'000 * kRowNs;

struct RadioFolder {
  Radio radio;
  const char* name;
};
constexpr std::array<RadioFolder, kRadioCount> kRadioFolders = {
    {{Radio::kWifi, "WIFI"}, {Radio::kBeacon, "BLE"}, {Radio::kZigbee, "Zigbee"}}};

struct Row {
  Eigen::Vector2d position;
  std::vector<double> rssi_dbm;  // per anchor
};

struct RadioTable {
  Radio radio = Radio::kWifi;
  std::vector<std::string> anchors;
  std::vector<Row> rows;
};

struct RadioFile {
  Radio radio;
  std::string path;
};

// The files of all radios that belong with `path`.
std::vector<RadioFile> RadioFiles(const std::string& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  std::vector<RadioFile> files;
  for (const RadioFolder& folder : kRadioFolders) {
    const fs::path file = whole.parent_path().parent_path() / folder.name / whole.filename();
    if (fs::is_regular_file(file)) files.push_back({folder.radio, file.string()});
  }
  return files;
}

std::vector<std::string> ReadAnchors(const std::string& path, std::string_view header) {
  if (!header.starts_with(kHeaderBegin)) {
    throw InputError(path, 1, "another header", "'x;y;RSSI A;RSSI B;...'");
  }
  FieldReader fields(header, ';');
  fields.Next();
  fields.Next();
  std::vector<std::string> anchors;
  while (!fields.exhausted()) {
    std::string_view name = fields.Next();
    if (name.starts_with(kAnchorPrefix)) name.remove_prefix(kAnchorPrefix.size());
    anchors.emplace_back(name);
  }
  return anchors;
}

bool ParseRow(FieldReader fields, std::size_t anchors, Row* row) {
  if (!ParseDouble(fields.Next(), &row->position.x()) ||
      !ParseDouble(fields.Next(), &row->position.y())) {
    return false;
  }
  row->rssi_dbm.resize(anchors);
  for (double& rssi : row->rssi_dbm) {
    if (!ParseDouble(fields.Next(), &rssi)) return false;
  }
  return fields.exhausted();
}

RadioTable ReadTable(const RadioFile& file, ReadReport* report) {
  const std::string text = ReadFileBytes(file.path);
  report->bytes += static_cast<std::int64_t>(text.size());
  LineReader lines(text);
  std::string_view line;
  lines.Next(&line);
  RadioTable table;
  table.radio = file.radio;
  table.anchors = ReadAnchors(file.path, line);
  while (lines.Next(&line)) {
    if (line.empty()) continue;
    Row row;
    if (!lines.terminated()) {
      CountCutLine(report);
    } else if (ParseRow(FieldReader(line, ';'), table.anchors.size(), &row)) {
      table.rows.push_back(std::move(row));
    } else {
      CountMalformed(lines.number(), report);
    }
  }
  report->lines += lines.number();
  report->records[RadioName(file.radio)] = static_cast<std::int64_t>(table.rows.size());
  return table;
}

void ReverseReadings(RadioTable* table) {
  const std::size_t count = table->rows.size();
  for (std::size_t i = 0; i < count / 2; ++i) {
    std::swap(table->rows[i].rssi_dbm, table->rows[count - 1 - i].rssi_dbm);
  }
}

void AddReadings(const RadioTable& table, TimeNs begin, bool keep_unheard,
                 RecordingBuilder* builder) {
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const TimeNs time = begin + static_cast<TimeNs>(i) * kRowNs;
    for (std::size_t a = 0; a < table.anchors.size(); ++a) {
      const double rssi = table.rows[i].rssi_dbm[a];
      if (rssi <= kUnheardDbm && !keep_unheard) continue;
      builder->AddRadioRow(table.radio, table.anchors[a], time, time, rssi);
    }
  }
}

// The route of the first table, and how many rows of the others contradict it.
void AddRoute(const std::vector<RadioTable>& tables, TimeNs begin, RecordingBuilder* builder,
              ReadReport* report) {
  if (tables.empty()) return;
  const std::vector<Row>& route = tables.front().rows;
  for (std::size_t i = 0; i < route.size(); ++i) {
    builder->AddWaypoint(begin + static_cast<TimeNs>(i) * kRowNs, route[i].position, 0);
  }
  for (const RadioTable& table : tables) {
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      if (i < route.size() &&
          (table.rows[i].position - route[i].position).norm() <= kSamePositionM) {
        continue;
      }
      ++report->hazards["position_disagreement"];
    }
  }
}

}  // namespace

bool LooksLikeSwiblux(std::string_view beginning) { return beginning.starts_with(kHeaderBegin); }

bool StandsForSwibluxRecording(const std::string& path) {
  const std::vector<RadioFile> files = RadioFiles(path);
  return !files.empty() && files.front().path == fs::absolute(path).lexically_normal().string();
}

Walk ReadSwiblux(const std::string& path, const ReaderSettings& settings) {
  Walk walk;
  walk.report.format = "swiblux";
  RecordingBuilder builder(&walk.report);
  const bool test = fs::path(path).stem() == "Test";
  const TimeNs begin = test ? kTestBeginNs : 0;
  std::vector<RadioTable> tables;
  for (const RadioFile& file : RadioFiles(path)) {
    RadioTable& table = tables.emplace_back(ReadTable(file, &walk.report));
    if (test && settings.swiblux_reverse_wifi_test && table.radio == Radio::kWifi) {
      ReverseReadings(&table);
    }
    AddReadings(table, begin, settings.swiblux_keep_unheard, &builder);
  }
  AddRoute(tables, begin, &builder, &walk.report);
  builder.Finish(&walk.recording, &walk.truth);
  return walk;
}

bool IsSwibluxSet(const std::string& folder) {
  if (!fs::is_regular_file(fs::path(folder) / kLimitsFile)) return false;
  return std::any_of(kRadioFolders.begin(), kRadioFolders.end(), [&](const RadioFolder& radio) {
    return fs::is_directory(fs::path(folder) / radio.name);
  });
}

Floor ReadSwibluxRoom(const std::string& folder) {
  const std::string path = (fs::path(folder) / kLimitsFile).string();
  const std::string text = ReadFileBytes(path);
  LineReader lines(text);
  std::string_view line;
  std::vector<double> limits;
  while (lines.Next(&line)) {
    double limit = 0;
    if (ParseDouble(line, &limit)) limits.push_back(limit);
  }
  if (limits.size() != 4 || !(limits[0] < limits[1]) || !(limits[2] < limits[3])) {
    throw InputError(path, 0, "no rectangle", "four numbers: x from, x to, y from, y to");
  }
  Floor room;
  room.name = "room";
  room.min_corner = {limits[0], limits[2]};
  room.max_corner = {limits[1], limits[3]};
  room.outline = {
      {room.min_corner, {limits[1], limits[2]}, room.max_corner, {limits[0], limits[3]}}};
  return room;
}

}  // namespace walkgraph
