#ifndef WALKGRAPH_EVAL_REPORT_RESULT_FOLDER_H_
#define WALKGRAPH_EVAL_REPORT_RESULT_FOLDER_H_

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace walkgraph {

// What the report page draws of one result folder:
//   name      the folder's
//   building  building.json; a floor's image has its PNG in "data" as a data URI, or is left out if
//             the file is not there
//   summary   summary.json, or null
//   methods   names, in the order of the walks' files
//   walks     by id: {"walk", "survey_distance_m" (null if unknown),
//             "waypoints": [[s, x, y, floor]],
//             "methods": {name: {"status", "messages", "errors_m", "track"}}}
// A track has the arrays t (s), x, y (m, to 1 cm), floor and xx, xy, yy (m^2, to 1 cm^2, null where
// the method has none). Times count from the walk's first waypoint or pose.
// Throws InputError with the file, and the line of a table, that cannot be read.
nlohmann::ordered_json ReadResultFolder(const std::string& dir);

// Standard alphabet, padded (RFC 4648).
std::string Base64(std::string_view bytes);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_REPORT_RESULT_FOLDER_H_
