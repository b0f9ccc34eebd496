#ifndef WALKGRAPH_DATA_FORMATS_RECORD_COUNTER_H_
#define WALKGRAPH_DATA_FORMATS_RECORD_COUNTER_H_

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "data/read_report.h"

namespace walkgraph {

// Counts rows per record type. A file has a handful of types and repeats them millions of times, so
// a scan over a short list beats a map. The names point into the text that is being read.
class RecordCounter {
 public:
  void Count(std::string_view type) {
    for (auto& [name, count] : counts_) {
      if (name == type) {
        ++count;
        return;
      }
    }
    if (counts_.size() < kMostTypes) {
      counts_.emplace_back(type, 1);
    } else {
      ++others_;
    }
  }

  void AddTo(std::map<std::string, std::int64_t>* records) const {
    for (const auto& [name, count] : counts_) (*records)[std::string(name)] += count;
    if (others_ > 0) (*records)["(others)"] += others_;
  }

 private:
  // A garbled file could invent a type per line; formats have fewer than thirty.
  static constexpr std::size_t kMostTypes = 64;
  std::vector<std::pair<std::string_view, std::int64_t>> counts_;
  std::int64_t others_ = 0;
};

inline void CountMalformed(std::int64_t line_number, ReadReport* report) {
  ++report->hazards["malformed"];
  if (report->first_malformed_line == 0) report->first_malformed_line = line_number;
}

// A last line without its newline may have lost digits of its last number, which then still parses:
// it is never used.
inline void CountCutLine(ReadReport* report) {
  report->cut_last_line = true;
  ++report->hazards["cut_line"];
}

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_FORMATS_RECORD_COUNTER_H_
