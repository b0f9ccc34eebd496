#include <filesystem>
#include <nlohmann/json.hpp>

#include "data/formats/ilc20.h"
#include "data/formats/text_input.h"
#include "data/input_error.h"

namespace walkgraph {
namespace {

using nlohmann::json;

// The plans say nothing about heights. A usual storey of a shopping mall keeps floors apart in
// drawings and z columns; no estimator compares it with a measurement, for these walks have no
// barometer.
constexpr double kNominalStoreyHeightM = 5.0;

// A millimetre in degrees: keeps a degenerate outline from dividing by zero.
constexpr double kSmallestExtentDeg = 1e-8;

std::string JoinPath(const std::string& folder, const char* file) {
  return (std::filesystem::path(folder) / file).string();
}

json ParseJsonFile(const std::string& path) {
  const std::string text = ReadFileBytes(path);
  try {
    return json::parse(text);
  } catch (const json::exception& error) {
    throw InputError(path, 0, error.what(), "a JSON document");
  }
}

// A linear ring in degrees (x longitude, y latitude) without its repeated last vertex.
Polygon ReadRing(const json& ring) {
  Polygon polygon;
  for (const json& vertex : ring) {
    polygon.emplace_back(vertex.at(0).get<double>(), vertex.at(1).get<double>());
  }
  if (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
  return polygon;
}

// All rings of a GeoJSON Polygon or MultiPolygon; other geometries have no area.
std::vector<Polygon> ReadRings(const json& geometry) {
  std::vector<Polygon> rings;
  const std::string type = geometry.at("type").get<std::string>();
  const json& coordinates = geometry.at("coordinates");
  if (type == "Polygon") {
    for (const json& ring : coordinates) rings.push_back(ReadRing(ring));
  } else if (type == "MultiPolygon") {
    for (const json& polygon : coordinates) {
      for (const json& ring : polygon) rings.push_back(ReadRing(ring));
    }
  }
  std::erase_if(rings, [](const Polygon& ring) { return ring.size() < 3; });
  return rings;
}

void ReadPlan(const json& map, Floor* floor) {
  bool first = true;
  for (const json& feature : map.at("features")) {
    std::vector<Polygon> rings = ReadRings(feature.at("geometry"));
    std::vector<Polygon>& target = first ? floor->outline : floor->obstacles;
    target.insert(target.end(), rings.begin(), rings.end());
    first = false;
  }
}

// Degrees to plan metres: the outline's bounding box becomes the plan's rectangle.
void MapToPlan(Floor* floor) {
  Eigen::Vector2d low = floor->outline.front().front();
  Eigen::Vector2d high = low;
  for (const Polygon& ring : floor->outline) {
    for (const Eigen::Vector2d& vertex : ring) {
      low = low.cwiseMin(vertex);
      high = high.cwiseMax(vertex);
    }
  }
  const Eigen::Array2d extent = (high - low).cwiseMax(kSmallestExtentDeg);
  const Eigen::Array2d scale = floor->max_corner.array() / extent;
  for (std::vector<Polygon>* rings : {&floor->outline, &floor->obstacles}) {
    for (Polygon& ring : *rings) {
      for (Eigen::Vector2d& vertex : ring) vertex = (vertex - low).array() * scale;
    }
  }
}

int FloorNumber(const std::string& folder, const std::string& name) {
  const std::optional<int> number = Ilc20FloorNumber(name);
  if (!number) {
    throw InputError(folder, 0, "floor name '" + name + "' says no number",
                     "a folder named like B1 or F2");
  }
  return *number;
}

}  // namespace

std::optional<int> Ilc20FloorNumber(std::string_view floor_name) {
  if (floor_name.empty()) return std::nullopt;
  std::int64_t count = 0;
  const char first = floor_name.front();
  const bool suffixed = floor_name.back() == 'F';
  const bool parsed = suffixed ? ParseInt64(floor_name.substr(0, floor_name.size() - 1), &count)
                               : ParseInt64(floor_name.substr(1), &count);
  if (!parsed || count < 1 || count > 200) return std::nullopt;
  if (suffixed || first == 'F' || first == 'L') return static_cast<int>(count) - 1;
  if (first == 'B') return -static_cast<int>(count);
  return std::nullopt;
}

bool IsIlc20Floor(const std::string& folder) {
  return std::filesystem::is_regular_file(JoinPath(folder, "floor_info.json"));
}

Floor ReadIlc20Floor(const std::string& folder) {
  Floor floor;
  floor.name = std::filesystem::path(folder).filename().string();
  floor.number = FloorNumber(folder, floor.name);
  floor.height_m = kNominalStoreyHeightM * floor.number;
  const std::string info_path = JoinPath(folder, "floor_info.json");
  const std::string map_path = JoinPath(folder, "geojson_map.json");
  try {
    const json document = ParseJsonFile(info_path);
    const json& info = document.at("map_info");
    floor.max_corner = {info.at("width").get<double>(), info.at("height").get<double>()};
  } catch (const json::exception& error) {
    throw InputError(info_path, 0, error.what(), "map_info with width and height in metres");
  }
  if (!(floor.max_corner.minCoeff() > 0) || !floor.max_corner.allFinite()) {
    throw InputError(info_path, 0, "the plan has no area", "a positive width and height");
  }
  if (std::filesystem::is_regular_file(map_path)) {
    try {
      ReadPlan(ParseJsonFile(map_path), &floor);
    } catch (const json::exception& error) {
      throw InputError(map_path, 0, error.what(), "a GeoJSON feature collection of polygons");
    }
    if (floor.outline.empty()) {
      throw InputError(map_path, 0, "the first feature has no area", "the floor's outline");
    }
    MapToPlan(&floor);
  }
  const std::string image_path = JoinPath(folder, "floor_image.png");
  if (std::filesystem::is_regular_file(image_path)) {
    floor.image = {image_path, floor.min_corner, floor.max_corner};
  }
  return floor;
}

}  // namespace walkgraph
