#include "eval/report/study_report.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>

#include "data/input_error.h"
#include "eval/files.h"
#include "eval/report/figures/plot.h"
#include "eval/report/figures/study_figures.h"
#include "eval/report/page.h"
#include "eval/report/page_text.h"
#include "eval/study/study_output.h"
#include "eval/study/study_results.h"
#include "eval/table.h"
#include "eval/usage_error.h"

namespace walkgraph {
namespace {

namespace fs = std::filesystem;

std::string CellsDifference(const StudyRecord& a, const StudyRecord& b) {
  if (a.reference != b.reference) return "reference " + b.reference + " instead of " + a.reference;
  if (a.cells.size() != b.cells.size()) {
    return std::to_string(b.cells.size()) + " cells instead of " + std::to_string(a.cells.size());
  }
  for (std::size_t c = 0; c < a.cells.size(); ++c) {
    if (a.cells[c].name != b.cells[c].name ||
        a.cells[c].configuration != b.cells[c].configuration) {
      return "cell " + b.cells[c].name + " is configured otherwise";
    }
  }
  return "";
}

// The first folder's record, after checking that the others are of the same study.
StudyRecord CommonRecord(const std::vector<std::string>& dirs, bool allow_differences) {
  std::optional<StudyRecord> common;
  for (const std::string& dir : dirs) {
    const std::optional<StudyRecord> record = ReadStudyRecord(dir);
    if (!record) {
      throw UsageError(dir + ": no results of `walkgraph ablate`, as the others are");
    }
    if (!common) common = record;
    if (allow_differences) continue;
    std::string difference = DifferenceOfInputs(*common, *record);
    if (difference.empty()) difference = CellsDifference(*common, *record);
    if (!difference.empty()) {
      std::string what = dir;
      what.append(" and ").append(dirs.front()).append(" hold different studies: ");
      what.append(difference).append("; expected one study, or --allow_differences");
      throw UsageError(what);
    }
  }
  return *common;
}

// Mean wall time of each cell per walk, by data set; what cannot be read is left out, since timings
// are no results.
std::map<std::string, std::map<std::string, double>> ReadTimings(
    const std::vector<std::string>& dirs) {
  struct Sum {
    double seconds = 0;
    int n = 0;
  };
  std::map<std::string, std::map<std::string, Sum>> sums;
  for (const std::string& dir : dirs) {
    if (!fs::is_directory(dir + "/run")) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(dir + "/run")) {
      if (entry.path().filename() != "timings.csv") continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        // data set, walk, cell, seconds; only a cell's name may hold further commas
        const std::size_t first = line.find(','), last = line.rfind(',');
        const std::size_t second = line.find(',', first + 1);
        if (second == std::string::npos || second >= last) continue;
        double seconds = 0;
        const auto parsed =
            std::from_chars(line.data() + last + 1, line.data() + line.size(), seconds);
        if (parsed.ec != std::errc()) continue;
        Sum& sum = sums[line.substr(0, first)][line.substr(second + 1, last - second - 1)];
        sum.seconds += seconds;
        ++sum.n;
      }
    }
  }
  std::map<std::string, std::map<std::string, double>> means;
  for (const auto& [dataset, cells] : sums) {
    for (const auto& [cell, sum] : cells) means[dataset][cell] = sum.seconds / sum.n;
  }
  return means;
}

std::string Number(double value, int digits) { return FixedDecimals(value, digits); }

std::string Range(const Interval& interval) {
  if (std::isnan(interval.low)) return "-";
  return Number(interval.low, 2) + " to " + Number(interval.high, 2);
}

std::string HtmlRow(const std::vector<std::string>& cells, const char* tag) {
  std::string row = "<tr>";
  for (const std::string& cell : cells) {
    row.append("<").append(tag).append(">").append(EscapeXml(cell)).append("</").append(tag);
    row.append(">");
  }
  return row.append("</tr>\n");
}

std::string HtmlTable(const std::vector<std::string>& header,
                      const std::vector<std::vector<std::string>>& rows) {
  std::string table =
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\"><table class=\"sortable\">"
      "<thead>";
  table.append(HtmlRow(header, "th")).append("</thead><tbody>\n");
  for (const auto& row : rows) table.append(HtmlRow(row, "td"));
  return table.append("</tbody></table></div>\n");
}

std::string SectionHtml(const StudyRecord& record, const StudySection& section,
                        const std::map<std::string, double>& seconds) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t c = 0; c < record.cells.size(); ++c) {
    const CellStatistics& cell = section.cells[c];
    const ErrorSummary& e = cell.errors;
    const auto time = seconds.find(record.cells[c].name);
    rows.push_back({record.cells[c].name,
                    std::to_string(cell.walks),
                    std::to_string(e.n),
                    Number(e.mean_m, 2),
                    Range(cell.mean_interval_m),
                    Number(cell.compared.mean_m, 2),
                    Range(cell.compared.interval_m),
                    FormatP(cell.compared.corrected_p),
                    Number(e.median_m, 2),
                    Number(e.p75_m, 2),
                    Number(e.p90_m, 2),
                    Number(e.p95_m, 2),
                    Number(e.max_m, 1),
                    Number(e.rmse_m, 2),
                    Number(e.floor_accuracy, 3),
                    Number(e.coverage50, 3),
                    Number(e.coverage95, 3),
                    Number(e.nees, 2),
                    Number(cell.claimed.spearman, 2),
                    time == seconds.end() ? "-" : Number(time->second, 3)});
  }
  return HtmlTable(
      {"cell",          "walks",    "n",        "mean m",  "95 % interval", "minus reference m",
       "95 % interval", "p (Holm)", "median m", "p75 m",   "p90 m",         "p95 m",
       "max m",         "RMSE m",   "floor",    "in 50 %", "in 95 %",       "NEES",
       "claimed~true",  "s/walk"},
      rows);
}

std::string ContributionsHtml(const DatasetStatistics& statistics) {
  std::vector<std::vector<std::string>> rows;
  for (const FactorContribution& factor : statistics.contributions) {
    rows.push_back({factor.factor, Number(factor.removes_m, 3), Range(factor.interval_m)});
  }
  return HtmlTable({"factor", "takes off the mean error, m", "95 % interval"}, rows);
}

std::string BreakdownHtml(const StudyRecord& record, const DatasetStatistics& statistics) {
  // The whole table is a file; a page of 128 cells times 30 classes serves nobody.
  constexpr std::size_t kMostCells = 20;
  const std::size_t cells = std::min(record.cells.size(), kMostCells);
  std::vector<std::string> header = {"waypoints by", "class", "walks", "n"};
  for (std::size_t c = 0; c < cells; ++c) header.push_back(record.cells[c].name + ", mean m");
  std::vector<std::vector<std::string>> rows;
  for (const BreakdownRow& row : statistics.breakdown) {
    rows.push_back(
        {row.by, row.value, std::to_string(row.walks), std::to_string(row.cells.front().n)});
    for (std::size_t c = 0; c < cells; ++c) {
      rows.back().push_back(Number(row.cells[c].mean_m, 2));
    }
  }
  return HtmlTable(header, rows);
}

constexpr const char* kSectionNotes[] = {
    "every walk with waypoints; a cell without position counts at the middle of the map",
    "of those, walks less than 3 m from where somebody surveyed",
    "the walks on which every cell has a position"};

std::string DatasetHtml(const StudyRecord& record, const DatasetStatistics& statistics,
                        const std::vector<Figure>& figures,
                        const std::map<std::string, double>& seconds) {
  std::string html = "<section><h2>" + EscapeXml(statistics.name) + "</h2>\n";
  for (std::size_t s = 0; s < statistics.sections.size(); ++s) {
    const StudySection& section = statistics.sections[s];
    html.append("<details").append(s == 0 ? " open" : "").append("><summary>");
    html.append(EscapeXml(section.name)).append(": ").append(kSectionNotes[s]);
    html.append("</summary>\n").append(SectionHtml(record, section, seconds));
    html.append("</details>\n");
  }
  if (!statistics.contributions.empty()) {
    html.append("<h3>What each factor contributes</h3>\n").append(ContributionsHtml(statistics));
  }
  html.append("<details><summary>Broken down</summary>\n");
  html.append(BreakdownHtml(record, statistics)).append("</details>\n");
  for (const Figure& figure : figures) {
    html.append("<figure class=\"plot\">\n").append(figure.svg).append("</figure>\n");
  }
  return html.append("</section>\n");
}

std::string DescriptionHtml(const StudyRecord& record) {
  std::string text = "<p>walkgraph " + record.version + "; split by " + record.split + ", " +
                     std::to_string(record.folds) + " folds; floor " +
                     (record.floor_given ? "given" : "unknown") + "; reference " + record.reference;
  for (const auto& [key, value] : record.base) {
    text.append("; ").append(EscapeXml(key)).append("=").append(EscapeXml(value));
  }
  return text.append(".</p>\n");
}

}  // namespace

bool IsStudyFolder(const std::string& dir) { return fs::exists(dir + "/study.json"); }

void WriteStudyReport(const std::vector<std::string>& dirs, const std::string& out_file,
                      bool allow_differences) {
  const StudyRecord record = CommonRecord(dirs, allow_differences);
  const StudyResults results = ReadStudyResults(dirs, record);
  if (results.missing > 0) {
    throw InputError(dirs.front(), 0, std::to_string(results.missing) + " walks are missing",
                     "all shards of the study, finished");
  }
  const std::vector<DatasetStatistics> statistics = ComputeStatistics(results);
  const std::string beside = fs::path(out_file).replace_extension("").string();
  WriteStudyTables(beside, record, statistics);
  const auto timings = ReadTimings(dirs);
  std::string body = DescriptionHtml(record);
  for (std::size_t d = 0; d < statistics.size(); ++d) {
    const auto found = timings.find(statistics[d].name);
    const std::map<std::string, double> seconds =
        found == timings.end() ? std::map<std::string, double>() : found->second;
    const auto figures = StudyFigures(record, results.datasets[d], statistics[d], seconds);
    for (const Figure& figure : figures) {
      WriteFileWhole(beside + "/figures/" + statistics[d].name + "_" + figure.name + ".svg",
                     StandaloneSvg(figure.svg));
    }
    body += DatasetHtml(record, statistics[d], figures, seconds);
  }
  WriteFileWhole(out_file, FillTemplate(StudyTemplate(), {{"@STYLE@", PageStyle()},
                                                          {"@BODY@", body},
                                                          {"@SCRIPT@", StudyScript()}}));
}

}  // namespace walkgraph
