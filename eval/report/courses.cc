#include "eval/report/courses.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "eval/report/result_text.h"
#include "eval/split.h"

namespace walkgraph {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

// Three decimals of a small number, whole numbers of a large one: enough for a line on a screen.
Json RoundedToDigits(double value) {
  if (!std::isfinite(value) || value == 0) return Rounded(value, 1);
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 3);
  // Divided by a power of ten the text is short; multiplied by its inverse it need not be.
  return unit < 1 ? Json(std::round(value / unit) / std::round(1 / unit)) : Rounded(value, unit);
}

// {state: [[seconds, value, sigma]]} of states/<walk>.<method>.csv; empty where there is none.
Json StatesJson(const fs::path& path, std::int64_t begin_ns) {
  Json states = Json::object();
  const std::string text = ReadIfThere(path).value_or("");
  for (const std::string_view line : Split(text, '\n')) {
    const std::vector<std::string_view> fields = Split(line, ',');
    std::int64_t time_ns = 0;
    double value = 0, sigma = 0;
    if (fields.size() != 4 || !ParseWhole(fields[1], time_ns) || !ParseWhole(fields[2], value) ||
        !ParseWhole(fields[3], sigma)) {
      continue;
    }
    states[std::string(fields[0])].push_back({Rounded(Seconds(time_ns, begin_ns), 0.01),
                                              RoundedToDigits(value), RoundedToDigits(sigma)});
  }
  return states;
}

// {factor: [[seconds, residual in sigmas]]} of those that came often enough to have a course.
Json ResidualsJson(const Json& explanation, std::int64_t begin_ns) {
  constexpr std::size_t kFewest = 3;
  Json residuals = Json::object();
  for (const auto& [factor, rows] : explanation.at("residuals").items()) {
    if (rows.size() < kFewest) continue;
    for (const Json& row : rows) {
      residuals[factor].push_back({Rounded(Seconds(row.at(0).get<std::int64_t>(), begin_ns), 0.01),
                                   RoundedToDigits(std::sqrt(row.at(1).get<double>()))});
    }
  }
  return residuals;
}

}  // namespace

void AddCourses(const std::string& dir, Json* walk) {
  const std::string id = walk->at("walk").get<std::string>();
  const auto begin_ns = walk->at("begin_ns").get<std::int64_t>();
  for (auto& [method, entry] : walk->at("methods").items()) {
    std::string name = id;
    name.append(".").append(method);
    Json states = StatesJson(fs::path(dir) / "states" / (name + ".csv"), begin_ns);
    if (!states.empty()) entry["states"] = std::move(states);
    const fs::path path = fs::path(dir) / "explain" / (name + ".json");
    const std::optional<std::string> text = ReadIfThere(path);
    if (!text) continue;
    const Json explanation = ParseJson(path, *text);
    entry["residuals"] = ResidualsJson(explanation, begin_ns);
    if (walk->contains("barometer")) continue;
    for (const Json& sample : explanation.at("barometer")) {
      (*walk)["barometer"].push_back(
          {Rounded(Seconds(sample.at(0).get<std::int64_t>(), begin_ns), 0.1),
           Rounded(sample.at(1).get<double>(), 0.01)});
    }
  }
}

}  // namespace walkgraph
