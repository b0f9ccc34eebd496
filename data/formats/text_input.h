#ifndef WALKGRAPH_DATA_FORMATS_TEXT_INPUT_H_
#define WALKGRAPH_DATA_FORMATS_TEXT_INPUT_H_

#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

#include "data/time.h"

namespace walkgraph {

// The whole file in one read. Throws InputError where it is missing or cannot be read.
std::string ReadFileBytes(const std::string& path);

// At most `limit` bytes from the beginning; empty where the file cannot be read.
std::string ReadFileBeginning(const std::string& path, std::size_t limit);

// Walks over the lines of a text that stays in memory; "\n" and "\r\n" both end a line.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}

  // False at the end. The line has no terminator and points into the text.
  bool Next(std::string_view* line) {
    if (rest_.empty()) return false;
    ++number_;
    const void* found = std::memchr(rest_.data(), '\n', rest_.size());
    terminated_ = found != nullptr;
    const std::size_t length =
        terminated_ ? static_cast<std::size_t>(static_cast<const char*>(found) - rest_.data())
                    : rest_.size();
    *line = rest_.substr(0, length);
    rest_.remove_prefix(terminated_ ? length + 1 : length);
    if (!line->empty() && line->back() == '\r') line->remove_suffix(1);
    return true;
  }

  std::int64_t number() const { return number_; }  // of the last line, from 1
  bool terminated() const { return terminated_; }  // whether the last line ended in a newline

 private:
  std::string_view rest_;
  std::int64_t number_ = 0;
  bool terminated_ = true;
};

// Splits a line without copying. After the last field Next() returns empty fields and exhausted()
// is true.
class FieldReader {
 public:
  FieldReader(std::string_view line, char separator)
      : position_(line.data()), end_(line.data() + line.size()), separator_(separator) {}

  std::string_view Next() {
    if (position_ == nullptr) return {};
    const char* begin = position_;
    const char* p = begin;
    while (p != end_ && *p != separator_) ++p;
    position_ = p == end_ ? nullptr : p + 1;
    return {begin, static_cast<std::size_t>(p - begin)};
  }

  bool exhausted() const { return position_ == nullptr; }

  // What Next() has not yet returned.
  std::string_view Rest() const {
    return exhausted() ? std::string_view()
                       : std::string_view(position_, static_cast<std::size_t>(end_ - position_));
  }

 private:
  const char* position_;
  const char* end_;
  char separator_;
};

// Removes the last field of `line` and returns it; the whole line where there is no separator.
inline std::string_view TakeLastField(std::string_view* line, char separator) {
  const std::size_t at = line->rfind(separator);
  std::string_view field = *line;
  if (at == std::string_view::npos) {
    *line = {};
    return field;
  }
  field.remove_prefix(at + 1);
  line->remove_suffix(line->size() - at);
  return field;
}

// True where the whole field is one number. Infinities and NaN parse: the caller judges values.
inline bool ParseDouble(std::string_view field, double* value) {
  const char* end = field.data() + field.size();
  const auto result = std::from_chars(field.data(), end, *value);
  if (result.ec == std::errc::result_out_of_range && result.ptr == end) {
    *value = std::numeric_limits<double>::infinity();
    return true;
  }
  return result.ec == std::errc() && result.ptr == end;
}

inline bool ParseInt64(std::string_view field, std::int64_t* value) {
  const char* end = field.data() + field.size();
  const auto result = std::from_chars(field.data(), end, *value);
  return result.ec == std::errc() && result.ptr == end;
}

// A time in nanoseconds. False where it is no integer or too large to leave room for differences.
bool ParseNanosecondsNs(std::string_view field, TimeNs* time_ns);

// A time in milliseconds, exact. False where it is no integer or does not fit.
bool ParseMillisecondsNs(std::string_view field, TimeNs* time_ns);

// A time in seconds with up to nine decimals (further ones are cut), exact: it never passes through
// floating point. False where it is no such number or does not fit.
bool ParseSecondsNs(std::string_view field, TimeNs* time_ns);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_FORMATS_TEXT_INPUT_H_
