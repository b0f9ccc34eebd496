#ifndef WALKGRAPH_DATA_FORMATS_ILC20_H_
#define WALKGRAPH_DATA_FORMATS_ILC20_H_

#include <optional>
#include <string>
#include <string_view>

#include "data/building.h"
#include "data/dataset.h"

// The recordings of the Indoor Location Competition 2.0 (Microsoft Research and XYZ10, 2021;
// github.com/location-competition/indoor-location-competition-20). A site holds floors, a floor
// holds floor_info.json, geojson_map.json, floor_image.png and path_data_files/*.txt. Every floor
// has its own coordinates: metres on its plan, which is north up.

namespace walkgraph {

// Whether a file that begins like this is an ilc20 recording.
bool LooksLikeIlc20(std::string_view beginning);

// A recording, given the whole text. The floor of its waypoints is `floor`, 0 where that is
// unknown. Never throws on content: what is broken is counted in the report.
Walk ReadIlc20(std::string_view text, std::optional<int> floor);

// "B2" is -2, "F1" and "L1" are 0, "F3" and "3F" are 2; nullopt where the name says no number.
std::optional<int> Ilc20FloorNumber(std::string_view floor_name);

// The inverse: "B1" for -1, "F1" for 0.
std::string Ilc20FloorName(int number);

// Whether a folder is a floor of a site.
bool IsIlc20Floor(const std::string& folder);

// One floor from floor_info.json and geojson_map.json: the first feature is the outline, the others
// are obstacles. The plan's width and height are those of the outline's bounding box, so that box
// is mapped to (0, 0)-(width, height). Throws InputError on missing or malformed files.
Floor ReadIlc20Floor(const std::string& folder);

// Writes floor_info.json and geojson_map.json into `folder`, which is made where it does not exist.
// The outline is placed on the globe at `origin`, north up. Throws InputError where the floor has
// no outline, where its box does not begin at (0, 0), and where a file cannot be written.
void WriteIlc20Floor(const Floor& floor, const GeoReference& origin, const std::string& folder);

// Writes a recording with waypoints in metres of its floor's plan. Times are cut to milliseconds;
// beacons are named uuid_major_minor_mac. Throws InputError where the file cannot be written.
void WriteIlc20Walk(const Recording& recording, const Truth& truth, const std::string& path);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_FORMATS_ILC20_H_
