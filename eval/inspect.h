#ifndef WALKGRAPH_EVAL_INSPECT_H_
#define WALKGRAPH_EVAL_INSPECT_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "data/dataset.h"
#include "data/read_report.h"
#include "frontends/sensor_figures.h"
#include "frontends/settings.h"

namespace walkgraph {

// How regularly one sensor delivered.
struct StreamFigures {
  std::string name;  // with its unit: "accelerometer_mps2"
  std::int64_t samples = 0;
  double rate_hz = 0;         // one over the median interval
  double longest_gap_s = 0;   // between two samples
  int gaps = 0;               // intervals of more than ten median ones
  double starts_after_s = 0;  // the recording's begin
  double stops_before_s = 0;  // the recording's end
};

// What one recording holds and what is wrong with it.
struct Inspection {
  std::string id;
  std::string device;
  ReadReport report;
  double duration_s = 0;
  std::vector<StreamFigures> streams;  // the empty ones too
  std::int64_t radio_rows = 0;
  std::map<std::string, std::int64_t> transmitters;  // by radio
  // Rows as printed by unique readings as used, and other counts of the frontends.
  std::map<std::string, std::int64_t> evidence;
  std::int64_t waypoints = 0;
  SensorFigures sensors;  // empty without truth
};

// `building` turns WGS84 truth into metres and its rotation headings into directions; without an
// origin such truth is counted, but no sensor is compared with it.
Inspection InspectWalk(const Walk& walk, const Building& building,
                       const FrontendSettings& settings);

// For people.
std::string FormatInspection(const Inspection& inspection);

// Heading errors (signed mean and RMS, walking and standing) and distance rates of the straight
// legs of all walks together; empty where no walk has any.
std::string FormatSensorSummary(const std::vector<Inspection>& inspections);

// For programs: one JSON object with the fields of Inspection, without a newline.
std::string FormatInspectionJson(const Inspection& inspection);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_INSPECT_H_
