#ifndef WALKGRAPH_DATA_READ_REPORT_H_
#define WALKGRAPH_DATA_READ_REPORT_H_

#include <cstdint>
#include <map>
#include <string>

namespace walkgraph {

// What a reader met in one file. Everything that did not become a sample is counted here under a
// name, so that nothing is dropped silently; `walkgraph inspect` prints it.
struct ReadReport {
  std::string format;  // "ilc20", "getsensordata", "csv", "swiblux"
  std::int64_t bytes = 0;
  std::int64_t lines = 0;
  bool cut_last_line = false;  // the file does not end in a newline and its last line is not whole
  // Rows per record type as named in the file, whether used or not ("TYPE_WIFI", "ACCE").
  std::map<std::string, std::int64_t> records;
  // Rows or samples that were dropped or repaired, by hazard; data/formats/README.md lists the
  // names and what happens to each: "malformed", "non_finite", "duplicate_time", "backward_time",
  // ...
  std::map<std::string, std::int64_t> hazards;
  std::int64_t first_malformed_line = 0;  // 0: none

  std::int64_t HazardCount(const std::string& name) const {
    const auto it = hazards.find(name);
    return it == hazards.end() ? 0 : it->second;
  }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_READ_REPORT_H_
