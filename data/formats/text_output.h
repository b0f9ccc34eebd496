#ifndef WALKGRAPH_DATA_FORMATS_TEXT_OUTPUT_H_
#define WALKGRAPH_DATA_FORMATS_TEXT_OUTPUT_H_

#include <string>
#include <utility>
#include <vector>

#include "data/time.h"

namespace walkgraph {

// The fields of one line of text, with a separator between them.
class TextRow {
 public:
  explicit TextRow(char separator) : separator_(separator) {}

  TextRow& Text(const std::string& field);
  // Fixed decimals; "-0.00" is written as "0.00".
  TextRow& Number(double value, int decimals);
  // Seconds with `decimals` (up to 9) behind the point, cut and not rounded: rounding could put a
  // reading after its own row.
  TextRow& Seconds(TimeNs time_ns, int decimals);
  // Whole milliseconds, cut.
  TextRow& Milliseconds(TimeNs time_ns);

  const std::string& text() const { return text_; }

 private:
  char separator_;
  bool empty_ = true;
  std::string text_;
};

// Lines of several sensors, which are written by time as a phone would.
class TimedLines {
 public:
  void Add(TimeNs time_ns, const TextRow& row) { lines_.emplace_back(time_ns, row.text()); }
  // All lines in order of time (those of one time in the order in which they came), behind
  // `header`.
  std::string Join(const std::string& header);

 private:
  std::vector<std::pair<TimeNs, std::string>> lines_;
};

// Throws InputError where the file cannot be written.
void WriteTextFile(const std::string& path, const std::string& text);

// Makes the folder and those above it. Throws InputError where that cannot be done.
void MakeFolder(const std::string& folder);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_FORMATS_TEXT_OUTPUT_H_
