#include "data/formats/ilc20.h"

#include <Eigen/Core>

#include "data/formats/record_counter.h"
#include "data/formats/recording_builder.h"
#include "data/formats/text_input.h"

namespace walkgraph {
namespace {

constexpr std::size_t kBssidLength = 17;  // "a8:0c:ca:03:9d:d7"

bool IsBssid(std::string_view field) {
  return field.size() == kBssidLength && field[2] == ':' && field[5] == ':' && field[8] == ':' &&
         field[11] == ':' && field[14] == ':';
}

class Ilc20Reader {
 public:
  Ilc20Reader(std::optional<int> floor, ReadReport* report)
      : floor_(floor.value_or(0)), report_(report), builder_(report) {}

  void Read(std::string_view text, Walk* walk);

 private:
  void ReadHeader(std::string_view line);
  // False where the line is malformed.
  bool ReadRecord(std::string_view line);
  bool ReadWifi(TimeNs time, std::string_view values);
  bool ReadBeacon(TimeNs time, std::string_view values);
  bool ReadWaypoint(TimeNs time, std::string_view values);

  int floor_;
  ReadReport* report_;
  RecordingBuilder builder_;
  RecordCounter counter_;
  std::string device_;
  std::string beacon_name_;  // scratch
};

bool ParseVector(std::string_view values, Eigen::Vector3d* vector) {
  FieldReader fields(values, '\t');
  return ParseDouble(fields.Next(), &vector->x()) && ParseDouble(fields.Next(), &vector->y()) &&
         ParseDouble(fields.Next(), &vector->z());
}

void Ilc20Reader::ReadHeader(std::string_view line) {
  FieldReader fields(line, '\t');
  while (!fields.exhausted()) {
    const std::string_view field = fields.Next();
    if (field.starts_with("Model:")) device_ = field.substr(6);
  }
}

bool Ilc20Reader::ReadWifi(TimeNs time, std::string_view values) {
  // From the right, because an SSID may hold anything, tabs included. Old versions of the recorder
  // print no last-seen time.
  TimeNs heard = time;
  std::string_view bssid;
  std::string_view rssi;
  std::string_view ssid = values;
  const std::string_view last = TakeLastField(&ssid, '\t');
  const std::string_view second = TakeLastField(&ssid, '\t');
  const std::string_view third = TakeLastField(&ssid, '\t');
  if (IsBssid(third)) {
    bssid = third;
    rssi = second;
  } else {
    if (!ParseMillisecondsNs(last, &heard)) return false;
    rssi = third;
    bssid = TakeLastField(&ssid, '\t');
    if (!IsBssid(bssid)) return false;
  }
  double rssi_dbm = 0;
  if (!ParseDouble(rssi, &rssi_dbm)) return false;
  if (ssid.find('\t') != std::string_view::npos) ++report_->hazards["separator_in_ssid"];
  builder_.AddRadioRow(Radio::kWifi, bssid, time, heard, rssi_dbm);
  return true;
}

bool Ilc20Reader::ReadBeacon(TimeNs time, std::string_view values) {
  FieldReader fields(values, '\t');
  const std::string_view uuid = fields.Next();
  const std::string_view major = fields.Next();
  const std::string_view minor = fields.Next();
  fields.Next();  // transmit power
  const std::string_view rssi = fields.Next();
  fields.Next();  // distance, derived from the two
  const std::string_view mac = fields.Next();
  TimeNs heard = time;
  if (!fields.exhausted() && !ParseMillisecondsNs(fields.Next(), &heard)) return false;
  double rssi_dbm = 0;
  if (!ParseDouble(rssi, &rssi_dbm) || !IsBssid(mac)) return false;
  beacon_name_.assign(uuid).append("_").append(major).append("_").append(minor);
  beacon_name_.append("_").append(mac);
  builder_.AddRadioRow(Radio::kBeacon, beacon_name_, time, heard, rssi_dbm);
  return true;
}

bool Ilc20Reader::ReadWaypoint(TimeNs time, std::string_view values) {
  FieldReader fields(values, '\t');
  Eigen::Vector2d position;
  if (!ParseDouble(fields.Next(), &position.x())) return false;
  if (!ParseDouble(fields.Next(), &position.y())) return false;
  builder_.AddWaypoint(time, position, floor_);
  return true;
}

bool Ilc20Reader::ReadRecord(std::string_view line) {
  FieldReader fields(line, '\t');
  TimeNs time = 0;
  if (!ParseMillisecondsNs(fields.Next(), &time)) return false;
  const std::string_view type = fields.Next();
  if (!type.starts_with("TYPE_")) return false;
  counter_.Count(type);
  const std::string_view values = fields.Rest();
  if (type == "TYPE_WIFI") return ReadWifi(time, values);
  if (type == "TYPE_BEACON") return ReadBeacon(time, values);
  if (type == "TYPE_WAYPOINT") return ReadWaypoint(time, values);
  Eigen::Vector3d vector;
  if (type == "TYPE_ACCELEROMETER") {
    if (!ParseVector(values, &vector)) return false;
    builder_.AddAcceleration(time, vector);
  } else if (type == "TYPE_GYROSCOPE") {
    if (!ParseVector(values, &vector)) return false;
    builder_.AddAngularRate(time, vector);
  } else if (type == "TYPE_MAGNETIC_FIELD") {
    if (!ParseVector(values, &vector)) return false;
    builder_.AddMagneticField(time, vector);
  } else if (type == "TYPE_ROTATION_VECTOR") {
    if (!ParseVector(values, &vector)) return false;
    builder_.AddRotationVector(time, vector);
  } else if (type == "TYPE_PRESSURE") {
    double hpa = 0;
    if (!ParseDouble(FieldReader(values, '\t').Next(), &hpa)) return false;
    builder_.AddPressure(time, hpa);
  }
  return true;
}

void Ilc20Reader::Read(std::string_view text, Walk* walk) {
  LineReader lines(text);
  std::string_view line;
  while (lines.Next(&line)) {
    if (line.empty()) continue;
    if (line.front() == '#') {
      ReadHeader(line);
    } else if (!lines.terminated()) {
      CountCutLine(report_);
    } else if (!ReadRecord(line)) {
      CountMalformed(lines.number(), report_);
    }
  }
  report_->lines = lines.number();
  counter_.AddTo(&report_->records);
  builder_.Finish(&walk->recording, &walk->truth);
  walk->recording.device = device_;
}

}  // namespace

bool LooksLikeIlc20(std::string_view beginning) {
  LineReader lines(beginning);
  std::string_view line;
  while (lines.Next(&line)) {
    if (line.starts_with("#\tstartTime:") || line.starts_with("#\tSiteID:")) return true;
    FieldReader fields(line, '\t');
    TimeNs time = 0;
    if (ParseMillisecondsNs(fields.Next(), &time) && fields.Next().starts_with("TYPE_"))
      return true;
  }
  return false;
}

Walk ReadIlc20(std::string_view text, std::optional<int> floor) {
  Walk walk;
  walk.report.format = "ilc20";
  walk.report.bytes = static_cast<std::int64_t>(text.size());
  Ilc20Reader(floor, &walk.report).Read(text, &walk);
  return walk;
}

}  // namespace walkgraph
