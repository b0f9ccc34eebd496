#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "data/angle.h"
#include "data/formats/csv.h"
#include "data/formats/text_input.h"
#include "data/input_error.h"

namespace walkgraph {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t kSmallestPolygon = 3;

Eigen::Vector2d ReadPoint(const json& point) {
  return {point.at(0).get<double>(), point.at(1).get<double>()};
}

std::vector<Polygon> ReadPolygons(const json& floor, const char* key) {
  std::vector<Polygon> polygons;
  const auto found = floor.find(key);
  if (found == floor.end()) return polygons;
  for (const json& ring : *found) {
    Polygon polygon;
    for (const json& vertex : ring) polygon.push_back(ReadPoint(vertex));
    if (polygon.size() >= kSmallestPolygon) polygons.push_back(std::move(polygon));
  }
  return polygons;
}

WayNetwork ReadWays(const json& source) {
  WayNetwork ways;
  for (const json& node : source.at("nodes")) ways.nodes.push_back(ReadPoint(node));
  const auto count = static_cast<int>(ways.nodes.size());
  for (const json& source_link : source.at("links")) {
    const std::array<int, 2> link = {source_link.at(0).get<int>(), source_link.at(1).get<int>()};
    if (std::min(link[0], link[1]) < 0 || std::max(link[0], link[1]) >= count) {
      throw json::other_error::create(0, "a link of \"ways\" to a node that is not there", nullptr);
    }
    ways.links.push_back(link);
  }
  return ways;
}

void BoundOutline(Floor* floor) {
  floor->min_corner = floor->max_corner = floor->outline.front().front();
  for (const Polygon& ring : floor->outline) {
    for (const Eigen::Vector2d& vertex : ring) {
      floor->min_corner = floor->min_corner.cwiseMin(vertex);
      floor->max_corner = floor->max_corner.cwiseMax(vertex);
    }
  }
}

Floor ReadFloor(const json& source, const fs::path& folder) {
  Floor floor;
  floor.number = source.at("number").get<int>();
  floor.name = source.value("name", std::to_string(floor.number));
  floor.height_m = source.at("height_m").get<double>();
  floor.outline = ReadPolygons(source, "outline");
  floor.obstacles = ReadPolygons(source, "obstacles");
  if (const auto ways = source.find("ways"); ways != source.end()) floor.ways = ReadWays(*ways);
  if (source.contains("min_corner") || floor.outline.empty()) {
    floor.min_corner = ReadPoint(source.at("min_corner"));
    floor.max_corner = ReadPoint(source.at("max_corner"));
  } else {
    BoundOutline(&floor);
  }
  if (const auto image = source.find("image"); image != source.end()) {
    floor.image.path = (folder / image->at("path").get<std::string>()).string();
    floor.image.min_corner = ReadPoint(image->at("min_corner"));
    floor.image.max_corner = ReadPoint(image->at("max_corner"));
  }
  return floor;
}

constexpr std::array<std::string_view, 3> kConnectorKinds = {"stairs", "lift", "escalator"};

ConnectorKind ReadConnectorKind(const std::string& name) {
  const auto* const found = std::find(kConnectorKinds.begin(), kConnectorKinds.end(), name);
  if (found == kConnectorKinds.end()) {
    throw json::other_error::create(0, "connector kind '" + name + "'", nullptr);
  }
  return static_cast<ConnectorKind>(found - kConnectorKinds.begin());
}

Connector ReadConnector(const json& source) {
  Connector connector;
  connector.name = source.value("name", "");
  connector.kind = ReadConnectorKind(source.at("kind").get<std::string>());
  connector.radius_m = source.value("radius_m", connector.radius_m);
  for (const json& stop : source.at("stops")) {
    connector.stops.push_back({stop.at("floor").get<int>(), ReadPoint(stop.at("position"))});
  }
  if (connector.stops.size() < 2) {
    throw json::other_error::create(0, "connector '" + connector.name + "' joins no floors",
                                    nullptr);
  }
  std::stable_sort(
      connector.stops.begin(), connector.stops.end(),
      [](const ConnectorStop& a, const ConnectorStop& b) { return a.floor < b.floor; });
  return connector;
}

Building ReadBuilding(const json& source, const fs::path& folder) {
  Building building;
  building.name = source.value("name", "");
  for (const json& floor : source.at("floors")) building.floors.push_back(ReadFloor(floor, folder));
  std::sort(building.floors.begin(), building.floors.end(),
            [](const Floor& a, const Floor& b) { return a.number < b.number; });
  if (const auto connectors = source.find("connectors"); connectors != source.end()) {
    for (const json& connector : *connectors) {
      building.connectors.push_back(ReadConnector(connector));
    }
  }
  if (const auto origin = source.find("origin"); origin != source.end()) {
    building.origin = {origin->at("latitude_deg").get<double>(),
                       origin->at("longitude_deg").get<double>(),
                       DegreesToRadians(origin->at("rotation_deg").get<double>())};
  }
  return building;
}

json PointJson(const Eigen::Vector2d& point) { return json::array({point.x(), point.y()}); }

json PolygonsJson(const std::vector<Polygon>& polygons) {
  json result = json::array();
  for (const Polygon& polygon : polygons) {
    json ring = json::array();
    for (const Eigen::Vector2d& vertex : polygon) ring.push_back(PointJson(vertex));
    result.push_back(std::move(ring));
  }
  return result;
}

json WaysJson(const WayNetwork& ways) {
  json nodes = json::array();
  for (const Eigen::Vector2d& node : ways.nodes) nodes.push_back(PointJson(node));
  return {{"nodes", std::move(nodes)}, {"links", ways.links}};
}

json FloorJson(const Floor& floor, const fs::path& folder) {
  json result = {{"number", floor.number},
                 {"name", floor.name},
                 {"height_m", floor.height_m},
                 {"min_corner", PointJson(floor.min_corner)},
                 {"max_corner", PointJson(floor.max_corner)}};
  if (!floor.outline.empty()) result["outline"] = PolygonsJson(floor.outline);
  if (!floor.obstacles.empty()) result["obstacles"] = PolygonsJson(floor.obstacles);
  if (!floor.ways.empty()) result["ways"] = WaysJson(floor.ways);
  if (!floor.image.path.empty()) {
    result["image"] = {{"path", fs::path(floor.image.path).lexically_proximate(folder).string()},
                       {"min_corner", PointJson(floor.image.min_corner)},
                       {"max_corner", PointJson(floor.image.max_corner)}};
  }
  return result;
}

json ConnectorJson(const Connector& connector) {
  json result = {{"name", connector.name},
                 {"kind", kConnectorKinds[static_cast<std::size_t>(connector.kind)]},
                 {"radius_m", connector.radius_m},
                 {"stops", json::array()}};
  for (const ConnectorStop& stop : connector.stops) {
    result["stops"].push_back({{"floor", stop.floor}, {"position", PointJson(stop.position)}});
  }
  return result;
}

}  // namespace

Building ReadBuildingJson(const std::string& path) {
  const std::string text = ReadFileBytes(path);
  try {
    return ReadBuilding(json::parse(text), fs::path(path).parent_path());
  } catch (const json::exception& error) {
    throw InputError(path, 0, error.what(), "a building (see data/formats/README.md)");
  }
}

void WriteBuildingJson(const Building& building, const std::string& path) {
  json document = {{"name", building.name}, {"floors", json::array()}};
  const fs::path folder = fs::path(path).parent_path();
  for (const Floor& floor : building.floors) {
    document["floors"].push_back(FloorJson(floor, folder));
  }
  for (const Connector& connector : building.connectors) {
    document["connectors"].push_back(ConnectorJson(connector));
  }
  if (building.origin) {
    document["origin"] = {{"latitude_deg", building.origin->latitude_deg},
                          {"longitude_deg", building.origin->longitude_deg},
                          {"rotation_deg", RadiansToDegrees(building.origin->rotation_rad)}};
  }
  std::ofstream file(path, std::ios::binary);
  file << document.dump(1) << "\n";
  file.close();
  if (!file) throw InputError(path, 0, "cannot be written", "a writable folder");
}

}  // namespace walkgraph
