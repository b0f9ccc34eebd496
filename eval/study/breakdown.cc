#include "eval/study/breakdown.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "eval/table.h"

namespace walkgraph {
namespace {

using Walks = std::vector<const WalkCells*>;

// Where classes of a number begin and end; the last one has no end.
struct Scale {
  std::string by;
  std::vector<double> edges;  // ascending, from the first class's begin
  std::function<double(const WalkCells&, const StudyWaypoint&)> value;
};

// Edges double from class to class, about as fast as dead reckoning and maps lose certainty.
std::vector<Scale> Scales() {
  return {{"distance walked, m",
           {0, 10, 25, 50, 100, 200},
           [](const WalkCells&, const StudyWaypoint& point) { return point.distance_m; }},
          {"epoch, s",
           {0, 15, 30, 60, 120, 300},
           [](const WalkCells&, const StudyWaypoint& point) { return point.time_s; }},
          {"since the last scan, s",
           {0, 1, 2, 4, 8},
           [](const WalkCells&, const StudyWaypoint& point) { return point.since_scan_s; }},
          {"distance to the survey, m",
           {0, 3, 10, 30},
           [](const WalkCells& walk, const StudyWaypoint&) { return walk.survey_distance_m; }}};
}

// A class's place in the table and its name.
using ClassKey = std::pair<double, std::string>;

ClassKey ClassOf(const Scale& scale, double value) {
  if (std::isnan(value)) return {INFINITY, "none"};
  if (std::isinf(value)) return {INFINITY, "not surveyed"};
  const auto above = std::upper_bound(scale.edges.begin(), scale.edges.end(), value);
  // What lies before the scale, a waypoint before the recording began, counts to its first class.
  const auto begin = above == scale.edges.begin() ? above : std::prev(above);
  const std::string from = FixedDecimals(*begin, 0);
  const auto end = std::next(begin);
  return {*begin,
          end == scale.edges.end() ? from + " and more" : from + " to " + FixedDecimals(*end, 0)};
}

using Classify = std::function<ClassKey(const WalkCells&, const StudyWaypoint&)>;

void AddClasses(const std::string& by, const Classify& classify, const Walks& walks,
                std::size_t cells, std::vector<BreakdownRow>* rows) {
  struct Class {
    int walks = 0;
    const WalkCells* last = nullptr;
    std::vector<std::vector<WaypointError>> errors;  // by cell
  };
  std::map<ClassKey, Class> classes;
  for (const WalkCells* walk : walks) {
    for (std::size_t i = 0; i < walk->waypoints.size(); ++i) {
      Class& c = classes[classify(*walk, walk->waypoints[i])];
      c.errors.resize(cells);
      c.walks += c.last == walk ? 0 : 1;
      c.last = walk;
      for (std::size_t k = 0; k < cells; ++k) {
        c.errors[k].push_back(ScoredErrors(*walk, k)[i]);
      }
    }
  }
  for (const auto& [key, c] : classes) {
    BreakdownRow row{by, key.second, c.walks, {}};
    for (const auto& errors : c.errors) row.cells.push_back(Summarise(errors));
    rows->push_back(std::move(row));
  }
}

}  // namespace

std::vector<BreakdownRow> BreakDown(const Walks& walks, std::size_t cells) {
  std::vector<BreakdownRow> rows;
  for (const Scale& scale : Scales()) {
    AddClasses(
        scale.by,
        [&](const WalkCells& walk, const StudyWaypoint& point) {
          return ClassOf(scale, scale.value(walk, point));
        },
        walks, cells, &rows);
  }
  AddClasses(
      "floor",
      [](const WalkCells&, const StudyWaypoint& point) {
        return ClassKey{point.floor, std::to_string(point.floor)};
      },
      walks, cells, &rows);
  AddClasses(
      "phone",
      [](const WalkCells& walk, const StudyWaypoint&) {
        return ClassKey{0, walk.device.empty() ? "unknown" : walk.device};
      },
      walks, cells, &rows);
  return rows;
}

}  // namespace walkgraph
