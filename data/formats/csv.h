#ifndef WALKGRAPH_DATA_FORMATS_CSV_H_
#define WALKGRAPH_DATA_FORMATS_CSV_H_

#include <Eigen/Core>
#include <string>
#include <vector>

#include "data/building.h"
#include "data/dataset.h"
#include "data/recording.h"
#include "data/time.h"
#include "data/truth.h"

// walkgraph's own format, described in data/formats/README.md: a folder per walk with a CSV file
// per sensor, and building.json beside or above the walks.

namespace walkgraph {

// Whether a folder holds at least one of the format's CSV files.
bool IsCsvWalk(const std::string& folder);

// Reads a walk folder. Throws InputError where a file cannot be read or has a header of another
// format.
Walk ReadCsvWalk(const std::string& folder);

// The "trial" of walk.json; empty where it names none. Throws InputError on malformed JSON.
std::string ReadCsvTrial(const std::string& folder);

// How many decimals the writer keeps; sensible for phone sensors.
struct CsvPrecision {
  int time_s = 3;
  int acceleration_mps2 = 3;
  int angular_rate_radps = 4;
  int magnetic_field_ut = 2;
  int quaternion = 5;
  int pressure_hpa = 4;
  int rssi_dbm = 0;
  int waypoint = 3;  // metres; WGS84 is written with nine
};

// Writes a walk into `folder`, which is made where it does not exist. Empty streams give no file.
// Throws InputError where a file cannot be written.
void WriteCsvWalk(const Recording& recording, const Truth& truth, const CsvPrecision& precision,
                  const std::string& folder);

// Where a person exactly was at one time: what only a simulator knows.
struct PathPoint {
  TimeNs time_ns = 0;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  // building frame; z of the feet
  int floor = 0;                                         // the nearest one
  double heading_rad = 0;  // of walking, counter-clockwise from +x, unwrapped
};

// path.csv, a row per point. Readers of recordings leave it alone. Both throw InputError.
void WritePathCsv(const std::vector<PathPoint>& path, const std::string& file);
std::vector<PathPoint> ReadPathCsv(const std::string& file);

// building.json; image paths are relative to the file's folder. Throws InputError.
Building ReadBuildingJson(const std::string& path);
void WriteBuildingJson(const Building& building, const std::string& path);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_FORMATS_CSV_H_
