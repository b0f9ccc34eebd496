#include "data/formats/java_date.h"

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "data/formats/text_input.h"

namespace walkgraph {
namespace {

// A whole number from 0 to `most`.
bool ParseUpTo(std::string_view text, std::int64_t most, std::int64_t* value) {
  return ParseInt64(text, value) && *value >= 0 && *value <= most;
}

std::optional<std::chrono::seconds> ParseClock(std::string_view text) {
  FieldReader fields(text, ':');
  std::int64_t hour = 0, minute = 0, second = 0;
  if (!ParseUpTo(fields.Next(), 23, &hour) || !ParseUpTo(fields.Next(), 59, &minute) ||
      !ParseUpTo(fields.Next(), 60, &second)) {
    return std::nullopt;
  }
  return std::chrono::hours(hour) + std::chrono::minutes(minute) + std::chrono::seconds(second);
}

// What local time has over GMT.
std::chrono::minutes ParseZone(std::string_view text) {
  std::int64_t hours = 0, minutes = 0;
  const bool offset = text.size() == 9 && text.starts_with("GMT") &&
                      ParseUpTo(text.substr(4, 2), 14, &hours) &&
                      ParseUpTo(text.substr(7, 2), 59, &minutes);
  if (!offset) return std::chrono::minutes(0);
  const std::chrono::minutes size = std::chrono::hours(hours) + std::chrono::minutes(minutes);
  return text[3] == '-' ? -size : size;
}

}  // namespace

std::optional<TimeNs> ParseJavaDate(std::string_view text) {
  constexpr std::string_view kMonths = "JanFebMarAprMayJunJulAugSepOctNovDec";
  FieldReader fields(text, ' ');
  fields.Next();  // day of the week
  const std::string_view month_name = fields.Next();
  const std::size_t month = kMonths.find(month_name);
  std::int64_t day = 0, year = 0;
  if (month_name.size() != 3 || month == std::string_view::npos || month % 3 != 0 ||
      !ParseUpTo(fields.Next(), 31, &day)) {
    return std::nullopt;
  }
  const std::optional<std::chrono::seconds> clock = ParseClock(fields.Next());
  const std::chrono::minutes zone = ParseZone(fields.Next());
  if (!clock || !ParseUpTo(fields.Next(), 9999, &year)) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(year)),
                                         std::chrono::month(static_cast<unsigned>(month / 3 + 1)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) return std::nullopt;
  const auto time = std::chrono::sys_days(date) + *clock - zone;
  return std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch()).count() *
         kNsPerSecond;
}

}  // namespace walkgraph
