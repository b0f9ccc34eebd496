#ifndef WALKGRAPH_EVAL_REPORT_RESULT_TEXT_H_
#define WALKGRAPH_EVAL_REPORT_RESULT_TEXT_H_

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace walkgraph {

// What readers of result files share.

// nullopt where the file cannot be opened.
std::optional<std::string> ReadIfThere(const std::filesystem::path& path);

// Throws InputError with the path where the text is not JSON.
nlohmann::ordered_json ParseJson(const std::filesystem::path& path, const std::string& text);

// Whether the whole text is a number; it goes to `number`.
template <typename Number>
bool ParseWhole(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

// To a multiple of `unit`; null where the value is not finite.
nlohmann::ordered_json Rounded(double value, double unit);

double Seconds(std::int64_t time_ns, std::int64_t begin_ns);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_REPORT_RESULT_TEXT_H_
