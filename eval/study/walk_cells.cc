#include "eval/study/walk_cells.h"

#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>

#include "eval/files.h"

namespace walkgraph {
namespace {

using Json = nlohmann::ordered_json;

Json Number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

// Infinite and missing numbers are both null in JSON.
double NumberOf(const Json& json, double if_null = std::numeric_limits<double>::quiet_NaN()) {
  return json.is_null() ? if_null : json.get<double>();
}

Json ErrorsJson(const std::vector<WaypointError>& errors) {
  Json json = {{"error_m", Json::array()},
               {"floors_off", Json::array()},
               {"nees", Json::array()},
               {"claimed_m", Json::array()}};
  for (const WaypointError& error : errors) {
    json["error_m"].push_back(Number(error.error_m));
    json["floors_off"].push_back(error.floors_off);
    json["nees"].push_back(Number(error.nees));
    json["claimed_m"].push_back(Number(error.claimed_m));
  }
  return json;
}

std::vector<WaypointError> ErrorsOf(const Json& json, const std::vector<StudyWaypoint>& waypoints) {
  const std::size_t n = json.at("error_m").size();
  std::vector<WaypointError> errors(n);
  for (std::size_t i = 0; i < n; ++i) {
    errors[i].error_m = NumberOf(json["error_m"].at(i));
    errors[i].floors_off = json.at("floors_off").at(i).get<int>();
    errors[i].nees = NumberOf(json.at("nees").at(i));
    errors[i].claimed_m = NumberOf(json.at("claimed_m").at(i));
    errors[i].floor = waypoints.at(i).floor;
  }
  return errors;
}

Json WaypointsJson(const std::vector<StudyWaypoint>& waypoints) {
  Json json = Json::array();
  for (const StudyWaypoint& point : waypoints) {
    json.push_back({point.time_s, point.floor, point.distance_m, Number(point.since_scan_s)});
  }
  return json;
}

std::vector<StudyWaypoint> WaypointsOf(const Json& json) {
  std::vector<StudyWaypoint> waypoints;
  for (const Json& point : json) {
    waypoints.push_back({point.at(0).get<double>(), point.at(1).get<int>(),
                         point.at(2).get<double>(), NumberOf(point.at(3))});
  }
  return waypoints;
}

EstimateStatus StatusOf(const std::string& name) {
  for (int i = 0; i <= static_cast<int>(EstimateStatus::kDiverged); ++i) {
    if (StatusName(static_cast<EstimateStatus>(i)) == name) return static_cast<EstimateStatus>(i);
  }
  throw Json::other_error::create(0, "unknown status", nullptr);
}

WalkCells FromJson(const Json& head, const Json& cells) {
  WalkCells walk;
  walk.walk = head.at("walk").get<std::string>();
  walk.fold = head.at("fold").get<int>();
  walk.device = head.at("device").get<std::string>();
  walk.duration_s = head.at("duration_s").get<double>();
  const Json& distance = head.at("survey_distance_m");
  walk.survey_distance_m =
      distance.is_string() ? std::numeric_limits<double>::infinity() : NumberOf(distance);
  walk.error = head.at("error").get<std::string>();
  walk.waypoints = WaypointsOf(head.at("waypoints"));
  walk.centroid_errors = ErrorsOf(head.at("centroid"), walk.waypoints);
  for (const Json& cell : cells) {
    walk.cells.push_back({cell.at("cell").get<std::string>(),
                          cell.at("configuration").get<std::string>(),
                          StatusOf(cell.at("status").get<std::string>()),
                          cell.at("messages").get<std::vector<std::string>>(),
                          ErrorsOf(cell.at("errors"), walk.waypoints)});
  }
  return walk;
}

std::string Line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

constexpr std::string_view kChecksumBegins = "{\"checksum\": \"";
constexpr std::size_t kChecksumDigits = 16;

}  // namespace

const CellResult* FindCell(const WalkCells& walk, const std::string& cell,
                           const std::string& configuration) {
  for (const CellResult& result : walk.cells) {
    if (result.cell == cell && result.configuration == configuration) return &result;
  }
  return nullptr;
}

std::string FormatWalkCells(const WalkCells& walk) {
  const Json head = {
      {"walk", walk.walk},
      {"fold", walk.fold},
      {"device", walk.device},
      {"duration_s", walk.duration_s},
      {"survey_distance_m",
       std::isinf(walk.survey_distance_m) ? Json("infinite") : Number(walk.survey_distance_m)},
      {"error", walk.error},
      {"waypoints", WaypointsJson(walk.waypoints)},
      {"centroid", ErrorsJson(walk.centroid_errors)}};
  std::string body = "\n\"walk\": " + Line(head) + ",\n\"cells\": [";
  for (std::size_t i = 0; i < walk.cells.size(); ++i) {
    const CellResult& cell = walk.cells[i];
    const Json json = {{"cell", cell.cell},
                       {"configuration", cell.configuration},
                       {"status", StatusName(cell.status)},
                       {"messages", cell.messages},
                       {"errors", ErrorsJson(cell.errors)}};
    body += (i == 0 ? "\n" : ",\n") + Line(json);
  }
  body += "\n]}\n";
  return std::string(kChecksumBegins) + TextChecksum(body) + "\"," + body;
}

std::optional<WalkCells> ParseWalkCells(const std::string& text) {
  const std::size_t body = kChecksumBegins.size() + kChecksumDigits + 2;
  if (text.size() < body || text.compare(0, kChecksumBegins.size(), kChecksumBegins) != 0) {
    return std::nullopt;
  }
  const std::string checksum = text.substr(kChecksumBegins.size(), kChecksumDigits);
  if (checksum != TextChecksum(std::string_view(text).substr(body))) return std::nullopt;
  try {
    const Json json = Json::parse(text);
    return FromJson(json.at("walk"), json.at("cells"));
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace walkgraph
