#include "eval/report/result_folder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "data/input_error.h"
#include "eval/report/courses.h"
#include "eval/report/result_text.h"
#include "eval/split.h"

namespace walkgraph {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

// The named column of each row of a comma-separated table; NaN for an empty field.
constexpr std::array<std::string_view, 7> kColumns = {"time_ns", "x_m",    "y_m",   "floor",
                                                      "cov_xx",  "cov_xy", "cov_yy"};
struct Pose {
  std::int64_t time_ns = 0;
  std::array<double, 6> values{};  // the other columns
};

bool ParsePose(const std::vector<std::string_view>& fields,
               const std::array<std::size_t, 7>& columns, Pose& pose) {
  if (!ParseWhole(fields[columns[0]], pose.time_ns)) return false;
  for (std::size_t k = 1; k < columns.size(); ++k) {
    double& value = pose.values[k - 1];
    const bool optional = k >= 4;
    if (optional && fields[columns[k]].empty()) {
      value = std::nan("");
    } else if (!ParseWhole(fields[columns[k]], value)) {
      return false;
    }
  }
  return true;
}

std::vector<Pose> ParseTrajectory(const fs::path& path, const std::string& text) {
  std::vector<std::string_view> lines = Split(text, '\n');
  if (lines.back().empty()) lines.pop_back();
  if (lines.empty()) throw InputError(path.string(), 1, "an empty file", "a header line");
  const std::vector<std::string_view> header = Split(lines[0], ',');
  std::array<std::size_t, 7> columns{};
  for (std::size_t k = 0; k < kColumns.size(); ++k) {
    const auto found = std::find(header.begin(), header.end(), kColumns[k]);
    if (found == header.end()) {
      throw InputError(path.string(), 1, "no such column", std::string(kColumns[k]));
    }
    columns[k] = static_cast<std::size_t>(found - header.begin());
  }
  std::vector<Pose> poses(lines.size() - 1);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string_view> fields = Split(lines[i], ',');
    if (fields.size() != header.size() || !ParsePose(fields, columns, poses[i - 1])) {
      throw InputError(path.string(), static_cast<std::int64_t>(i) + 1, "a broken row",
                       std::to_string(header.size()) + " numbers");
    }
  }
  return poses;
}

Json TrackJson(const std::vector<Pose>& poses, std::int64_t begin_ns) {
  constexpr std::array<const char*, 6> kNames = {"x", "y", "floor", "xx", "xy", "yy"};
  Json track = {{"t", Json::array()}};
  for (const char* name : kNames) track[name] = Json::array();
  for (const Pose& pose : poses) {
    track["t"].push_back(Rounded(Seconds(pose.time_ns, begin_ns), 0.01));
    for (std::size_t k = 0; k < kNames.size(); ++k) {
      const double unit = k < 2 ? 0.01 : k == 2 ? 1 : 1e-4;
      track[kNames[k]].push_back(Rounded(pose.values[k], unit));
    }
  }
  return track;
}

using Tracks = std::map<std::string, std::vector<Pose>>;  // by method

// `description` is walks/<walk>.json, or null.
std::int64_t BeginNs(const Json& description, const Tracks& tracks) {
  if (!description.is_null() && !description.at("waypoints").empty()) {
    return description.at("waypoints").front().at("time_ns").get<std::int64_t>();
  }
  std::optional<std::int64_t> begin;
  for (const auto& [method, poses] : tracks) {
    if (!poses.empty()) begin = std::min(begin.value_or(poses[0].time_ns), poses[0].time_ns);
  }
  return begin.value_or(0);
}

Json WalkJson(const std::string& id, const Json& description, const Tracks& tracks) {
  const std::int64_t begin_ns = BeginNs(description, tracks);
  Json json = {{"walk", id},
               {"begin_ns", begin_ns},
               {"survey_distance_m", nullptr},
               {"waypoints", Json::array()},
               {"methods", Json::object()}};
  if (!description.is_null()) {
    json["survey_distance_m"] = description.at("survey_distance_m");
    for (const Json& point : description.at("waypoints")) {
      json["waypoints"].push_back(
          {Rounded(Seconds(point.at("time_ns").get<std::int64_t>(), begin_ns), 0.01),
           point.at("x_m"), point.at("y_m"), point.at("floor")});
    }
    json["methods"] = description.at("methods");
  }
  for (const auto& [method, poses] : tracks) {
    Json& entry = json["methods"][method];
    if (entry.is_null()) {
      entry = {{"status", nullptr}, {"messages", Json::array()}, {"errors_m", Json::array()}};
    }
    entry["track"] = TrackJson(poses, begin_ns);
  }
  return json;
}

// Files of a subfolder with the given extension, in the order of their names; none if it is
// missing.
std::vector<fs::path> FilesIn(const fs::path& dir, const std::string& extension) {
  std::vector<fs::path> paths;
  if (!fs::is_directory(dir)) return paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(dir)) {
    if (entry.path().extension() == extension) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

// Every walk of walks/<walk>.json and trajectories/<walk>.<method>.csv, by id.
Json ReadWalks(const fs::path& dir) {
  std::map<std::string, Json> descriptions;
  std::map<std::string, Tracks> tracks;
  for (const fs::path& path : FilesIn(dir / "walks", ".json")) {
    descriptions[path.stem().string()] = ParseJson(path, ReadIfThere(path).value_or(""));
  }
  for (const fs::path& path : FilesIn(dir / "trajectories", ".csv")) {
    const fs::path name = path.stem();  // <walk>.<method>, and a walk's id may hold dots
    if (!name.has_extension()) continue;
    const std::string id = name.stem().string();
    descriptions.try_emplace(id, nullptr);
    tracks[id][name.extension().string().substr(1)] =
        ParseTrajectory(path, ReadIfThere(path).value_or(""));
  }
  Json walks = Json::array();
  for (const auto& [id, description] : descriptions) {
    walks.push_back(WalkJson(id, description, tracks[id]));
    AddCourses(dir.string(), &walks.back());
  }
  return walks;
}

// The building with its plans inside. A path counts from the working directory, as it was written.
Json ReadBuilding(const fs::path& dir) {
  const fs::path path = dir / "building.json";
  const std::optional<std::string> text = ReadIfThere(path);
  if (!text) throw InputError(path.string(), 0, "not there", "a result folder of walkgraph");
  Json building = ParseJson(path, *text);
  for (Json& floor : building.at("floors")) {
    if (!floor.contains("image")) continue;
    const auto image = ReadIfThere(floor.at("image").at("path").get<std::string>());
    if (image) {
      floor["image"]["data"] = "data:image/png;base64," + Base64(*image);
      floor["image"].erase("path");
    } else {
      floor.erase("image");
    }
  }
  return building;
}

// Mean wall time per walk by method, from run/timings.csv; none where that is missing.
Json ReadSeconds(const fs::path& dir) {
  std::map<std::string, std::pair<double, int>> sums;
  const std::string text = ReadIfThere(dir / "run" / "timings.csv").value_or("");
  for (const std::string_view line : Split(text, '\n')) {
    const std::vector<std::string_view> fields = Split(line, ',');
    double seconds = 0;
    if (fields.size() != 3 || !ParseWhole(fields[2], seconds)) continue;
    auto& [sum, n] = sums[std::string(fields[1])];
    sum += seconds;
    ++n;
  }
  Json json = Json::object();
  for (const auto& [method, total] : sums) json[method] = total.first / total.second;
  return json;
}

Json MethodNames(const Json& walks) {
  Json names = Json::array();
  std::set<std::string> seen;
  for (const Json& walk : walks) {
    for (const auto& [method, result] : walk.at("methods").items()) {
      if (seen.insert(method).second) names.push_back(method);
    }
  }
  return names;
}

}  // namespace

Json ReadResultFolder(const std::string& dir) {
  const fs::path folder = fs::path(dir).lexically_normal();
  try {
    Json json = {{"name", (folder.has_filename() ? folder : folder.parent_path()).filename()},
                 {"building", ReadBuilding(folder)},
                 {"summary", nullptr}};
    const std::optional<std::string> summary = ReadIfThere(folder / "summary.json");
    if (summary) json["summary"] = ParseJson(folder / "summary.json", *summary);
    Json walks = ReadWalks(folder);
    json["seconds"] = ReadSeconds(folder);
    json["methods"] = MethodNames(walks);
    json["walks"] = std::move(walks);
    return json;
  } catch (const Json::exception& error) {
    throw InputError(dir, 0, error.what(), "result files of this version");
  }
}

}  // namespace walkgraph
