#include "data/formats/text_output.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <system_error>

#include "data/input_error.h"

namespace walkgraph {

TextRow& TextRow::Text(const std::string& field) {
  if (!empty_) text_ += separator_;
  empty_ = false;
  text_ += field;
  return *this;
}

TextRow& TextRow::Number(double value, int decimals) {
  char buffer[std::numeric_limits<double>::max_exponent10 + 64];
  const auto result =
      std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::fixed, decimals);
  std::string digits(buffer, result.ptr);
  if (digits.front() == '-' && digits.find_first_not_of("-0.") == std::string::npos) {
    digits.erase(0, 1);
  }
  return Text(digits);
}

TextRow& TextRow::Seconds(TimeNs time_ns, int decimals) {
  TimeNs unit_ns = kNsPerSecond;
  for (int i = 0; i < decimals; ++i) unit_ns /= 10;
  const bool negative = time_ns < 0;
  const TimeNs units = (negative ? -time_ns : time_ns) / unit_ns;
  std::string digits = std::to_string(units);
  const auto places = static_cast<std::size_t>(decimals);
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  if (places > 0) digits.insert(digits.size() - places, 1, '.');
  return Text(negative ? "-" + digits : digits);
}

TextRow& TextRow::Milliseconds(TimeNs time_ns) { return Text(std::to_string(time_ns / kNsPerMs)); }

std::string TimedLines::Join(const std::string& header) {
  std::stable_sort(lines_.begin(), lines_.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string text = header;
  for (const auto& [time_ns, line] : lines_) text.append(line).append("\n");
  return text;
}

void WriteTextFile(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file) throw InputError(path, 0, "cannot be written", "a writable folder");
}

void MakeFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder, 0, error.message(), "a folder that can be made");
}

}  // namespace walkgraph
