#include "data/formats/text_input.h"

#include <fstream>
#include <limits>

#include "data/input_error.h"

namespace walkgraph {
namespace {

// Times beyond this (some 146 years either way) would leave no room for differences in 64 bits.
constexpr std::int64_t kLargestSeconds =
    std::numeric_limits<std::int64_t>::max() / 2 / kNsPerSecond;

}  // namespace

std::string ReadFileBytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file ? static_cast<std::streamoff>(file.tellg()) : -1;
  if (size < 0) throw InputError(path, 0, "cannot be opened", "a readable file");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  file.seekg(0);
  if (!file.read(bytes.data(), size))
    throw InputError(path, 0, "cannot be read", "a readable file");
  return bytes;
}

std::string ReadFileBeginning(const std::string& path, std::size_t limit) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(limit, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(limit));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

bool ParseLongDouble(std::string_view field, double* value) {
  const char* end = field.data() + field.size();
  const auto result = std::from_chars(field.data(), end, *value);
  if (result.ec == std::errc::result_out_of_range && result.ptr == end) {
    *value = std::numeric_limits<double>::infinity();
    return true;
  }
  return result.ec == std::errc() && result.ptr == end;
}

bool ParseNanosecondsNs(std::string_view field, TimeNs* time_ns) {
  return ParseInt64(field, time_ns) && *time_ns <= kLargestSeconds * kNsPerSecond &&
         *time_ns >= -kLargestSeconds * kNsPerSecond;
}

bool ParseMillisecondsNs(std::string_view field, TimeNs* time_ns) {
  std::int64_t ms = 0;
  if (!ParseInt64(field, &ms)) return false;
  if (ms > kLargestSeconds * 1000 || ms < -kLargestSeconds * 1000) return false;
  *time_ns = ms * kNsPerMs;
  return true;
}

bool ParseLongSecondsNs(std::string_view field, TimeNs* time_ns) {
  const bool negative = !field.empty() && field.front() == '-';
  if (negative) field.remove_prefix(1);
  const char* end = field.data() + field.size();
  std::int64_t seconds = 0;
  const auto whole = std::from_chars(field.data(), end, seconds);
  if (whole.ec != std::errc() || seconds < 0 || seconds > kLargestSeconds) return false;
  std::int64_t fraction_ns = 0;
  if (whole.ptr != end) {
    if (*whole.ptr != '.') return false;
    std::int64_t unit_ns = kNsPerSecond;
    for (const char* digit = whole.ptr + 1; digit != end; ++digit) {
      if (*digit < '0' || *digit > '9') return false;
      unit_ns /= 10;
      fraction_ns += unit_ns * (*digit - '0');
    }
  }
  *time_ns = seconds * kNsPerSecond + fraction_ns;
  if (negative) *time_ns = -*time_ns;
  return true;
}

}  // namespace walkgraph
