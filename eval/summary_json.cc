#include "eval/summary_json.h"

#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>

#include "eval/config_keys.h"
#include "eval/version.h"

namespace walkgraph {
namespace {

using Json = nlohmann::ordered_json;

// A tenth of a millimetre is enough, and short numbers make a readable file.
Json Rounded(double value) {
  return std::isfinite(value) ? Json(std::round(value * 1e4) / 1e4) : Json(nullptr);
}

Json Bounds(const Interval& interval) {
  return Json::array({Rounded(interval.low), Rounded(interval.high)});
}

Json RowJson(const SummaryRow& row) {
  const ErrorSummary& e = row.errors;
  return {{"walks", row.walks},
          {"n", e.n},
          {"mean_m", Rounded(e.mean_m)},
          {"mean_interval_m", Bounds(row.mean_interval_m)},
          {"rmse_m", Rounded(e.rmse_m)},
          {"median_m", Rounded(e.median_m)},
          {"p75_m", Rounded(e.p75_m)},
          {"p90_m", Rounded(e.p90_m)},
          {"p95_m", Rounded(e.p95_m)},
          {"max_m", Rounded(e.max_m)},
          {"floor_accuracy", Rounded(e.floor_accuracy)},
          {"ipin_m", Rounded(e.ipin_m)},
          {"coverage50", Rounded(e.coverage50)},
          {"coverage95", Rounded(e.coverage95)},
          {"nees", Rounded(e.nees)},
          {"minus", Json::object()}};
}

Json SectionJson(const SummarySection& section) {
  Json json = Json::object();
  for (const SummaryRow& row : section.rows) json[row.method] = RowJson(row);
  for (const PairedDifference& difference : section.differences) {
    json[difference.method]["minus"][difference.other] = {
        {"mean_m", Rounded(difference.mean_m)}, {"interval_m", Bounds(difference.interval_m)}};
  }
  return json;
}

Json StatusJson(const Evaluation& evaluation) {
  Json json = Json::object();
  for (std::size_t i = 0; i < evaluation.methods.size(); ++i) {
    std::map<std::string, int> counts;
    for (const WalkOutcome& walk : evaluation.walks) {
      if (walk.finished) ++counts[std::string(StatusName(walk.methods[i].status))];
    }
    json[evaluation.methods[i]] = counts;
  }
  return json;
}

Json WalksJson(const Evaluation& evaluation) {
  int finished = 0, with_waypoints = 0;
  for (const WalkOutcome& walk : evaluation.walks) {
    if (!walk.finished) continue;
    ++finished;
    with_waypoints += walk.truth.waypoints.empty() ? 0 : 1;
  }
  return {{"total", evaluation.walks.size()},
          {"finished", finished},
          {"with_waypoints", with_waypoints}};
}

Json ConfigurationJson(const Settings& settings) {
  Settings copy = settings;
  Json json = Json::object();
  for (const ConfigKey& key : ConfigKeys(&copy)) json[key.name] = FormatValue(key);
  return json;
}

}  // namespace

std::string FormatSummaryJson(const Evaluation& evaluation,
                              const std::vector<SummarySection>& sections,
                              const RunDescription& run) {
  Json json = {{"version", Version()},
               {"split", run.split},
               {"folds", run.folds},
               {"floor_given", run.floor_given},
               {"walks", WalksJson(evaluation)},
               {"sections", Json::object()}};
  for (const SummarySection& section : sections) {
    json["sections"][section.name] = SectionJson(section);
  }
  json["status"] = StatusJson(evaluation);
  json["configuration"] = ConfigurationJson(run.settings);
  json["calibrated"] = run.calibrated;
  json["checksums"] = run.checksums;
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace walkgraph
