#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "data/formats/ilc20.h"
#include "data/formats/text_output.h"
#include "data/input_error.h"

namespace walkgraph {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr int kSensorDecimals = 6;
constexpr int kQuaternionDecimals = 8;  // the fourth number follows from the other three
constexpr int kWaypointDecimals = 4;
constexpr char kAccuracy[] = "3";       // Android's "high"
constexpr char kChannelMhz[] = "2437";  // of channel 6: a simulator knows none
constexpr double kBeaconPowerDbm = -59.0;

TextRow Row(TimeNs time_ns, const char* type) {
  return TextRow('\t').Milliseconds(time_ns).Text(type);
}

void AddVectors(const Stream<Eigen::Vector3d>& stream, const char* type, TimedLines* lines) {
  for (std::size_t i = 0; i < stream.size(); ++i) {
    TextRow row = Row(stream.time_ns[i], type);
    for (const double component : stream.value[i]) row.Number(component, kSensorDecimals);
    lines->Add(stream.time_ns[i], row.Text(kAccuracy));
  }
}

// The scalar part follows from the norm, so it must not be negative.
void AddRotations(const Stream<Eigen::Quaterniond>& stream, TimedLines* lines) {
  for (std::size_t i = 0; i < stream.size(); ++i) {
    const double sign = stream.value[i].w() < 0 ? -1.0 : 1.0;
    TextRow row = Row(stream.time_ns[i], "TYPE_ROTATION_VECTOR");
    for (const double component : stream.value[i].vec()) {
      row.Number(sign * component, kQuaternionDecimals);
    }
    lines->Add(stream.time_ns[i], row.Text(kAccuracy));
  }
}

void AddWifi(const RadioRow& row, const std::string& bssid, TimedLines* lines) {
  lines->Add(row.printed_ns, Row(row.printed_ns, "TYPE_WIFI")
                                 .Text("simulated")
                                 .Text(bssid)
                                 .Number(row.rssi_dbm, 0)
                                 .Text(kChannelMhz)
                                 .Milliseconds(row.heard_ns));
}

void AddBeacon(const RadioRow& row, const std::string& name, TimedLines* lines) {
  TextRow text = Row(row.printed_ns, "TYPE_BEACON");
  std::size_t begin = 0;
  for (int part = 0; part < 3; ++part) {  // uuid, major, minor
    const std::size_t end = name.find('_', begin);
    text.Text(name.substr(begin, end - begin));
    begin = end == std::string::npos ? name.size() : end + 1;
  }
  text.Number(kBeaconPowerDbm, 0).Number(row.rssi_dbm, 0);
  text.Number(std::pow(10.0, (kBeaconPowerDbm - row.rssi_dbm) / 20.0), 3);  // distance, m
  lines->Add(row.printed_ns, text.Text(name.substr(begin)).Milliseconds(row.heard_ns));
}

json RingJson(const Polygon& ring, const GeoReference& origin) {
  json coordinates = json::array();
  for (std::size_t i = 0; i <= ring.size(); ++i) {  // the first vertex closes the ring
    const Eigen::Vector2d degrees = BuildingToWgs84(ring[i % ring.size()], origin);
    coordinates.push_back(json::array({degrees.y(), degrees.x()}));
  }
  return coordinates;
}

// Every ring becomes a polygon of its own: the reader applies the even-odd rule to all of them.
json FeatureJson(const std::vector<Polygon>& rings, const GeoReference& origin) {
  json polygons = json::array();
  for (const Polygon& ring : rings) {
    polygons.push_back(json::array({RingJson(ring, origin)}));
  }
  return {{"type", "Feature"},
          {"properties", json::object()},
          {"geometry", {{"type", "MultiPolygon"}, {"coordinates", polygons}}}};
}

}  // namespace

std::string Ilc20FloorName(int number) {
  std::string name = number < 0 ? "B" : "F";
  return name.append(std::to_string(number < 0 ? -number : number + 1));
}

void WriteIlc20Floor(const Floor& floor, const GeoReference& origin, const std::string& folder) {
  if (floor.outline.empty() || !floor.min_corner.isZero()) {
    throw InputError(folder, 0,
                     "floor " + std::to_string(floor.number) + " has no plan from (0, 0)",
                     "an outline whose box begins there");
  }
  const GeoReference north_up = {origin.latitude_deg, origin.longitude_deg, 0.0};
  json features = json::array({FeatureJson(floor.outline, north_up)});
  for (const Polygon& obstacle : floor.obstacles) {
    features.push_back(FeatureJson({obstacle}, north_up));
  }
  const json info = {
      {"map_info", {{"width", floor.max_corner.x()}, {"height", floor.max_corner.y()}}}};
  const json map = {{"type", "FeatureCollection"}, {"features", features}};
  MakeFolder(folder);
  WriteTextFile((fs::path(folder) / "floor_info.json").string(), info.dump(1) + "\n");
  WriteTextFile((fs::path(folder) / "geojson_map.json").string(), map.dump() + "\n");
}

void WriteIlc20Walk(const Recording& recording, const Truth& truth, const std::string& path) {
  TimedLines lines;
  AddVectors(recording.accelerometer_mps2, "TYPE_ACCELEROMETER", &lines);
  AddVectors(recording.gyroscope_radps, "TYPE_GYROSCOPE", &lines);
  AddVectors(recording.magnetometer_ut, "TYPE_MAGNETIC_FIELD", &lines);
  AddRotations(recording.rotation_vector, &lines);
  for (std::size_t i = 0; i < recording.pressure_hpa.size(); ++i) {
    const TimeNs time_ns = recording.pressure_hpa.time_ns[i];
    lines.Add(time_ns, Row(time_ns, "TYPE_PRESSURE")
                           .Number(recording.pressure_hpa.value[i], kSensorDecimals)
                           .Text(kAccuracy));
  }
  for (const RadioRow& row : recording.radio_rows) {
    const Transmitter& transmitter = recording.transmitters.at(row.transmitter);
    if (transmitter.radio == Radio::kWifi) {
      AddWifi(row, transmitter.name, &lines);
    } else {
      AddBeacon(row, transmitter.name, &lines);
    }
  }
  for (const Waypoint& waypoint : truth.waypoints) {
    lines.Add(waypoint.time_ns, Row(waypoint.time_ns, "TYPE_WAYPOINT")
                                    .Number(waypoint.position.x(), kWaypointDecimals)
                                    .Number(waypoint.position.y(), kWaypointDecimals));
  }
  std::string header = "#\tstartTime:" + std::to_string(recording.begin_ns / kNsPerMs) + "\n";
  header += "#\tBrand:walkgraph\tModel:" + recording.device + "\n";
  WriteTextFile(path, lines.Join(header));
}

}  // namespace walkgraph
