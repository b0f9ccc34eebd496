#include "eval/study/study_output.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "eval/evaluate.h"
#include "eval/files.h"
#include "eval/table.h"
#include "eval/table_files.h"

namespace walkgraph {
namespace {

using Json = nlohmann::ordered_json;

Json Number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json Bounds(const Interval& interval) {
  return Json::array({Number(interval.low), Number(interval.high)});
}

Json ErrorsJson(const ErrorSummary& e) {
  return {{"n", e.n},
          {"mean_m", Number(e.mean_m)},
          {"rmse_m", Number(e.rmse_m)},
          {"median_m", Number(e.median_m)},
          {"p75_m", Number(e.p75_m)},
          {"p90_m", Number(e.p90_m)},
          {"p95_m", Number(e.p95_m)},
          {"max_m", Number(e.max_m)},
          {"floor_accuracy", Number(e.floor_accuracy)},
          {"ipin_m", Number(e.ipin_m)},
          {"coverage50", Number(e.coverage50)},
          {"coverage95", Number(e.coverage95)},
          {"nees", Number(e.nees)}};
}

Json CellJson(const CellStatistics& cell) {
  Json json = {{"walks", cell.walks}};
  json.update(ErrorsJson(cell.errors));
  json["mean_interval_m"] = Bounds(cell.mean_interval_m);
  const ComparedWithReference& compared = cell.compared;
  json["minus_reference"] = {
      {"mean_m", Number(compared.mean_m)},    {"interval_m", Bounds(compared.interval_m)},
      {"walks_that_differ", compared.test.n}, {"w_plus", Number(compared.test.w_plus)},
      {"p", Number(compared.test.p_value)},   {"p_corrected", Number(compared.corrected_p)}};
  json["claimed_with_true_error"] = {{"n", cell.claimed.n},
                                     {"pearson", Number(cell.claimed.pearson)},
                                     {"spearman", Number(cell.claimed.spearman)}};
  return json;
}

Json DatasetJson(const StudyRecord& record, const DatasetStatistics& dataset) {
  Json json = {{"sections", Json::object()},
               {"breakdown", Json::array()},
               {"contributions", Json::object()},
               {"status", Json::object()}};
  for (const StudySection& section : dataset.sections) {
    Json& cells = json["sections"][section.name] = Json::object();
    for (std::size_t c = 0; c < record.cells.size(); ++c) {
      cells[record.cells[c].name] = CellJson(section.cells[c]);
    }
  }
  for (const BreakdownRow& row : dataset.breakdown) {
    Json item = {{"by", row.by}, {"value", row.value}, {"walks", row.walks}};
    for (std::size_t c = 0; c < record.cells.size(); ++c) {
      item["cells"][record.cells[c].name] = ErrorsJson(row.cells[c]);
    }
    json["breakdown"].push_back(std::move(item));
  }
  for (const FactorContribution& factor : dataset.contributions) {
    json["contributions"][factor.factor] = {{"removes_m", Number(factor.removes_m)},
                                            {"interval_m", Bounds(factor.interval_m)}};
  }
  for (std::size_t c = 0; c < record.cells.size(); ++c) {
    json["status"][record.cells[c].name] = dataset.status[c];
  }
  return json;
}

std::string Range(const Interval& interval, int digits) {
  if (std::isnan(interval.low)) return "-";
  return FixedDecimals(interval.low, digits) + " .. " + FixedDecimals(interval.high, digits);
}

Table CellsTable(const StudyRecord& record, const DatasetStatistics& dataset,
                 const StudySection& section, int digits) {
  Table table({section.name + " (" + dataset.name + ")", "walks", "n", "mean", "95% interval",
               "minus reference", "95% interval", "p (Holm)", "rmse", "median", "p75", "p90", "p95",
               "max", "floor", "cover50", "cover95", "nees", "claimed~true"});
  for (std::size_t c = 0; c < record.cells.size(); ++c) {
    const CellStatistics& cell = section.cells[c];
    const ErrorSummary& e = cell.errors;
    const auto metres = [digits](double value) { return FixedDecimals(value, digits); };
    table.AddRow({record.cells[c].name, std::to_string(cell.walks), std::to_string(e.n),
                  metres(e.mean_m), Range(cell.mean_interval_m, digits),
                  metres(cell.compared.mean_m), Range(cell.compared.interval_m, digits),
                  FormatP(cell.compared.corrected_p), metres(e.rmse_m), metres(e.median_m),
                  metres(e.p75_m), metres(e.p90_m), metres(e.p95_m), metres(e.max_m),
                  FixedDecimals(e.floor_accuracy, 3), FixedDecimals(e.coverage50, 3),
                  FixedDecimals(e.coverage95, 3), FixedDecimals(e.nees, 2),
                  FixedDecimals(cell.claimed.spearman, 2)});
  }
  return table;
}

Table BreakdownTable(const StudyRecord& record, const DatasetStatistics& dataset, int digits) {
  Table table({"cell", "by", "value", "walks", "n", "mean", "median", "p90", "floor", "cover95"});
  for (std::size_t c = 0; c < record.cells.size(); ++c) {
    for (const BreakdownRow& row : dataset.breakdown) {
      const ErrorSummary& e = row.cells[c];
      table.AddRow({record.cells[c].name, row.by, row.value, std::to_string(row.walks),
                    std::to_string(e.n), FixedDecimals(e.mean_m, digits),
                    FixedDecimals(e.median_m, digits), FixedDecimals(e.p90_m, digits),
                    FixedDecimals(e.floor_accuracy, 3), FixedDecimals(e.coverage95, 3)});
    }
  }
  return table;
}

Table ContributionsTable(const DatasetStatistics& dataset, int digits) {
  Table table({"factor (" + dataset.name + ")", "removes, m", "95% interval"});
  for (const FactorContribution& factor : dataset.contributions) {
    table.AddRow(
        {factor.factor, FixedDecimals(factor.removes_m, digits), Range(factor.interval_m, digits)});
  }
  return table;
}

constexpr int kDigits = 2, kCsvDigits = 4;

}  // namespace

std::string FormatP(double p) {
  if (!std::isnan(p) && p < 1e-4) return "< 0.0001";
  return FixedDecimals(p, 4);
}

std::string FormatStudySummary(const StudyRecord& record,
                               const std::vector<DatasetStatistics>& statistics) {
  Json json = {{"version", record.version},     {"split", record.split},
               {"folds", record.folds},         {"floor_given", record.floor_given},
               {"reference", record.reference}, {"datasets", Json::object()}};
  for (const DatasetStatistics& dataset : statistics) {
    json["datasets"][dataset.name] = DatasetJson(record, dataset);
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void WriteStudyTables(const std::string& dir, const StudyRecord& record,
                      const std::vector<DatasetStatistics>& statistics) {
  TableFiles cells, breakdown, contributions;
  for (const DatasetStatistics& dataset : statistics) {
    for (const StudySection& section : dataset.sections) {
      cells.Add(CellsTable(record, dataset, section, kDigits),
                CellsTable(record, dataset, section, kCsvDigits));
    }
    breakdown.Add(BreakdownTable(record, dataset, kDigits),
                  BreakdownTable(record, dataset, kCsvDigits));
    if (dataset.contributions.empty()) continue;
    contributions.Add(ContributionsTable(dataset, kDigits),
                      ContributionsTable(dataset, kCsvDigits));
  }
  const std::string scratch = dir + "/run/unfinished";
  cells.Write(dir + "/tables/cells", scratch);
  breakdown.Write(dir + "/tables/breakdown", scratch);
  if (!contributions.empty()) contributions.Write(dir + "/tables/contributions", scratch);
  WriteFileWholeVia(scratch, dir + "/summary.json", FormatStudySummary(record, statistics));
}

int FinishStudy(const std::string& dir, const StudyRecord& record) {
  const StudyResults results = ReadStudyResults({dir}, record);
  if (results.missing > 0) {
    std::printf(
        "%zu walks of the study are missing: run the other shards into %s, or merge their "
        "folders with `walkgraph report`\n",
        results.missing, dir.c_str());
    return kExitOk;
  }
  const std::vector<DatasetStatistics> statistics = ComputeStatistics(results);
  WriteStudyTables(dir, record, statistics);
  bool any_position = false;
  for (const DatasetStatistics& dataset : statistics) {
    for (const StudySection& section : dataset.sections) {
      std::fputs((CellsTable(record, dataset, section, kDigits).Format() + "\n").c_str(), stdout);
    }
    if (!dataset.contributions.empty()) {
      std::fputs((ContributionsTable(dataset, kDigits).Format() + "\n").c_str(), stdout);
    }
  }
  for (const DatasetResults& dataset : results.datasets) {
    for (const WalkCells& walk : dataset.walks) {
      for (const CellResult& cell : walk.cells) any_position |= !cell.errors.empty();
    }
  }
  return any_position ? kExitOk : kExitNoTrajectory;
}

}  // namespace walkgraph
