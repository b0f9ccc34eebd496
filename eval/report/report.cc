#include "eval/report/report.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "eval/bootstrap.h"
#include "eval/files.h"
#include "eval/report/explain.h"
#include "eval/report/figures/figures.h"
#include "eval/report/page.h"
#include "eval/report/page_text.h"
#include "eval/report/result_folder.h"
#include "eval/suggest.h"
#include "eval/table.h"
#include "eval/table_files.h"
#include "eval/usage_error.h"

namespace walkgraph {
namespace {

// JSON inside a script element: no "</script>" and no "<!--" may end or hide it.
std::string EscapeForScript(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

// Numbers of two versions, or of other recordings, do not belong into one table. A folder of
// `smooth` has no summary and nothing to compare.
void RequireSameInputs(const nlohmann::ordered_json& first, const nlohmann::ordered_json& other) {
  if (first.at("summary").is_null() || other.at("summary").is_null()) return;
  for (const char* key : {"version", "checksums"}) {
    const auto &a = first.at("summary").at(key), &b = other.at("summary").at(key);
    if (a == b) continue;
    const auto names =
        first.at("name").get<std::string>() + " and " + other.at("name").get<std::string>();
    const std::string what =
        a.is_string() ? "versions " + a.get<std::string>() + " and " + b.get<std::string>()
                      : "different recordings, as their checksums say";
    throw UsageError(names + " hold results of " + what +
                     "; expected the same, or --allow_differences");
  }
}

std::vector<double> NumbersOf(const nlohmann::ordered_json& list) {
  std::vector<double> numbers;
  for (const auto& item : list) numbers.push_back(item.is_null() ? NAN : item.get<double>());
  return numbers;
}

FigureSeries SeriesOf(const nlohmann::ordered_json& run, const std::string& method) {
  FigureSeries series;
  series.name = method;
  std::vector<WalkTotal> totals;
  for (const auto& walk : run.at("walks")) {
    const auto entry = walk.at("methods").find(method);
    if (entry == walk.at("methods").end() || entry->at("errors_m").empty()) continue;
    const std::vector<double> errors = NumbersOf(entry->at("errors_m"));
    const std::vector<double> nees = NumbersOf(entry->value("nees", nlohmann::ordered_json()));
    WalkTotal total{0, static_cast<int>(errors.size())};
    for (std::size_t i = 0; i < errors.size(); ++i) {
      WaypointError error;
      error.error_m = errors[i];
      if (i < nees.size()) error.nees = nees[i];
      total.sum += errors[i];
      series.errors.push_back(error);
    }
    totals.push_back(total);
  }
  series.walks = static_cast<int>(totals.size());
  series.mean_m = PooledMean(totals);
  series.mean_interval_m = BootstrapMean(totals);
  const auto seconds = run.at("seconds").find(method);
  if (seconds != run.at("seconds").end()) series.seconds_per_walk = seconds->get<double>();
  return series;
}

// Each method on the walks on which it has errors; the titles count them.
std::vector<Figure> RunFigures(const nlohmann::ordered_json& run) {
  std::vector<FigureSeries> series;
  for (const auto& method : run.at("methods")) {
    series.push_back(SeriesOf(run, method.get<std::string>()));
    if (series.back().errors.empty()) series.pop_back();
  }
  if (series.empty()) return {};
  std::vector<Figure> figures = {BoxFigure(series), MeansFigure(series)};
  const auto any = [&](auto&& has) { return std::any_of(series.begin(), series.end(), has); };
  if (any([](const FigureSeries& s) { return !std::isnan(s.errors.front().nees); })) {
    figures.push_back(CalibrationFigure(series));
  }
  if (any([](const FigureSeries& s) { return s.seconds_per_walk > 0; })) {
    figures.push_back(TimeFigure(series));
  }
  return figures;
}

// A section of summary.json as a table.
Table SectionTable(const std::string& name, const nlohmann::ordered_json& section, int digits) {
  Table table({name, "walks", "n", "mean", "95% interval", "rmse", "median", "p75", "p90", "p95",
               "max", "floor", "cover50", "cover95", "nees"});
  const auto text = [](const nlohmann::ordered_json& value, int decimals) {
    return value.is_null() ? "-" : FixedDecimals(value.get<double>(), decimals);
  };
  for (const auto& [method, row] : section.items()) {
    const auto& interval = row.at("mean_interval_m");
    std::vector<std::string> fields = {
        method, std::to_string(row.at("walks").get<int>()), std::to_string(row.at("n").get<int>()),
        text(row.at("mean_m"), digits),
        text(interval.at(0), digits) + " .. " + text(interval.at(1), digits)};
    for (const char* key : {"rmse_m", "median_m", "p75_m", "p90_m", "p95_m", "max_m"}) {
      fields.push_back(text(row.at(key), digits));
    }
    for (const char* key : {"floor_accuracy", "coverage50", "coverage95", "nees"}) {
      fields.push_back(text(row.at(key), 3));
    }
    table.AddRow(std::move(fields));
  }
  return table;
}

void WriteRunTables(const nlohmann::ordered_json& run, const std::string& beside) {
  if (run.at("summary").is_null()) return;
  TableFiles tables;
  for (const auto& [name, section] : run.at("summary").at("sections").items()) {
    tables.Add(SectionTable(name, section, 2), SectionTable(name, section, 4));
  }
  const std::string stem = beside + "/tables/" + run.at("name").get<std::string>();
  tables.Write(stem, beside + "/tables");
  WriteFileWhole(stem + ".json", run.at("summary").dump(1) + "\n");
}

void WritePage(const nlohmann::ordered_json& data, const std::string& out_file) {
  const std::string json =
      data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  const std::string style = std::string(PageLibraryStyle()) + std::string(PageStyle());
  WriteFileWhole(out_file, FillTemplate(PageTemplate(), {{"@STYLE@", style},
                                                         {"@DATA@", EscapeForScript(json)},
                                                         {"@LIBRARY@", PageLibrary()},
                                                         {"@SCRIPT@", PageScript()}}));
}

}  // namespace

void WriteReport(const std::vector<std::string>& result_dirs, const std::string& out_file,
                 bool allow_differences) {
  nlohmann::ordered_json data = {{"runs", nlohmann::ordered_json::array()}};
  for (const std::string& dir : result_dirs) {
    data["runs"].push_back(ReadResultFolder(dir));
    if (!allow_differences) RequireSameInputs(data["runs"].front(), data["runs"].back());
  }
  const std::string beside = std::filesystem::path(out_file).replace_extension("").string();
  for (auto& run : data["runs"]) {
    WriteRunTables(run, beside);
    run["figures"] = nlohmann::ordered_json::array();
    const std::string prefix = beside + "/figures/" + run.at("name").get<std::string>() + "_";
    for (const Figure& figure : RunFigures(run)) {
      run["figures"].push_back(figure.svg);
      WriteFileWhole(prefix + figure.name + ".svg", StandaloneSvg(figure.svg));
    }
  }
  WritePage(data, out_file);
}

void WriteWalkReport(const std::string& result_dir, const std::string& walk,
                     const std::string& out_file) {
  nlohmann::ordered_json run = ReadResultFolder(result_dir);
  std::vector<std::string> names;
  nlohmann::ordered_json found;
  for (const auto& candidate : run.at("walks")) {
    names.push_back(candidate.at("walk").get<std::string>());
    if (names.back() == walk) found = candidate;
  }
  if (found.is_null()) {
    throw UsageError("--walk=" + walk + ": no such walk in " + result_dir +
                     DidYouMean(walk, names));
  }
  const Explanation explanation = ExplainWalk(result_dir, found);
  run["walks"] = nlohmann::ordered_json::array({found});
  run["summary"] = nullptr;  // of all walks, which are not here
  run["notes"] = explanation.notes;
  run["figures"] = nlohmann::ordered_json::array();
  for (const Figure& figure : explanation.figures) run["figures"].push_back(figure.svg);
  WritePage({{"runs", nlohmann::ordered_json::array({run})}}, out_file);
}

}  // namespace walkgraph
