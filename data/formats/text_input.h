#ifndef WALKGRAPH_DATA_FORMATS_TEXT_INPUT_H_
#define WALKGRAPH_DATA_FORMATS_TEXT_INPUT_H_

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
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

// A number as sensors print it: a few digits with at most one point among or behind them.
struct ShortDecimal {
  std::int64_t digits = 0;   // without the point, below 10^15
  std::size_t decimals = 0;  // how many of them stand behind the point
  bool negative = false;
};

// False where the field is anything else.
inline bool ScanShortDecimal(std::string_view field, ShortDecimal* decimal) {
  constexpr std::ptrdiff_t kLongest = 15;
  const char* p = field.data();
  const char* end = p + field.size();
  decimal->negative = p != end && *p == '-';
  if (decimal->negative) ++p;
  const char* begin = p;
  const char* point = nullptr;
  if (p == end || end - p > kLongest) return false;
  std::int64_t digits = 0;
  for (; p != end; ++p) {
    const unsigned digit = static_cast<unsigned char>(*p) - unsigned{'0'};
    if (digit <= 9) {
      digits = digits * 10 + digit;
    } else if (*p == '.' && point == nullptr && p != begin) {
      point = p;
    } else {
      return false;
    }
  }
  decimal->digits = digits;
  decimal->decimals = point == nullptr ? 0 : static_cast<std::size_t>(end - point - 1);
  return true;
}

// The rest of ParseDouble: exponents, many digits, infinities, NaN, and what is no number.
bool ParseLongDouble(std::string_view field, double* value);

// True where the whole field is one number, which is rounded correctly. Infinities and NaN parse:
// the caller judges values.
//
// Digits and power of ten of a short number are both exact in a double, so that one division rounds
// correctly (Clinger, PLDI 1990); std::from_chars does the rest, at a third of the speed.
inline bool ParseDouble(std::string_view field, double* value) {
  constexpr double kPowerOfTen[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6, 1e7,
                                    1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14};
  ShortDecimal decimal;
  if (!ScanShortDecimal(field, &decimal)) return ParseLongDouble(field, value);
  const double magnitude = static_cast<double>(decimal.digits) / kPowerOfTen[decimal.decimals];
  *value = decimal.negative ? -magnitude : magnitude;
  return true;
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

// The rest of ParseSecondsNs: many digits, and what is no time.
bool ParseLongSecondsNs(std::string_view field, TimeNs* time_ns);

// A time in seconds with up to nine decimals (further ones are cut), exact: it never passes through
// floating point. False where it is no such number or does not fit.
inline bool ParseSecondsNs(std::string_view field, TimeNs* time_ns) {
  constexpr TimeNs kUnitNs[] = {1'000'000'000, 100'000'000, 10'000'000, 1'000'000, 100'000,
                                10'000,        1'000,       100,        10,        1};
  constexpr std::int64_t kLargestDigits = 1'000'000'000;  // with the largest unit still 30 years
  ShortDecimal decimal;
  if (!ScanShortDecimal(field, &decimal) || decimal.decimals > 9 ||
      decimal.digits > kLargestDigits) {
    return ParseLongSecondsNs(field, time_ns);
  }
  const TimeNs magnitude = decimal.digits * kUnitNs[decimal.decimals];
  *time_ns = decimal.negative ? -magnitude : magnitude;
  return true;
}

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_FORMATS_TEXT_INPUT_H_
