#include "eval/honesty/honesty_output.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "eval/table.h"
#include "eval/version.h"

namespace walkgraph {
namespace {

using Json = nlohmann::ordered_json;

std::vector<HonestyRow> Rows(const HonestyResult& result) {
  std::vector<HonestyRow> rows;
  for (std::size_t m = 0; m < result.methods.size(); ++m) {
    rows.push_back(SummariseHonesty(result.methods[m], result.outcomes[m]));
  }
  return rows;
}

std::string WithInterval(const MeanWithInterval& value, int digits) {
  return FixedDecimals(value.mean, digits) + " (" + FixedDecimals(value.interval.low, digits) +
         " .. " + FixedDecimals(value.interval.high, digits) + ")";
}

std::string FormatCovariances(const std::vector<HonestyRow>& rows) {
  Table table({"method", "walks", "none", "n", "error m", "NEES/dim", "median", "cover50",
               "cover95", "beyond99.9", "s/walk"});
  for (const HonestyRow& row : rows) {
    table.AddRow({row.method, std::to_string(row.walks), std::to_string(row.no_answer),
                  std::to_string(row.n), FixedDecimals(row.error_m.mean, 2),
                  WithInterval(row.nees_per_dimension, 2),
                  FixedDecimals(row.median_nees_per_dimension, 2), WithInterval(row.coverage50, 3),
                  WithInterval(row.coverage95, 3), FixedDecimals(row.beyond_999, 4),
                  FixedDecimals(row.seconds_per_walk, 2)});
  }
  return table.Format();
}

std::string MeanSquare(const StatisticsByType& statistics, const std::string& type) {
  const auto found = statistics.find(type);
  return found == statistics.end() ? "-" : FixedDecimals(found->second.MeanSquare(), 3);
}

std::string FormatResiduals(const HonestyResult& result, const std::vector<HonestyRow>& rows) {
  StatisticsByType types = result.at_truth;
  for (const HonestyRow& row : rows) types.insert(row.statistics.begin(), row.statistics.end());
  std::vector<std::string> header = {"mean square", "count", "at truth"};
  for (const HonestyRow& row : rows) {
    header.push_back(row.method);
    if (!row.innovations.empty()) header.push_back(row.method + " innovation");
  }
  Table table(header);
  for (const auto& [type, statistics] : types) {
    std::vector<std::string> line = {type, std::to_string(statistics.count),
                                     MeanSquare(result.at_truth, type)};
    for (const HonestyRow& row : rows) {
      line.push_back(MeanSquare(row.statistics, type));
      if (!row.innovations.empty()) line.push_back(MeanSquare(row.innovations, type));
    }
    table.AddRow(line);
  }
  return table.Format();
}

Json Number(double value) {
  return std::isfinite(value) ? Json(std::round(value * 1e4) / 1e4) : Json(nullptr);
}

Json NumberJson(const MeanWithInterval& value) {
  return {{"mean", Number(value.mean)},
          {"interval", {Number(value.interval.low), Number(value.interval.high)}}};
}

Json StatisticsJson(const StatisticsByType& statistics) {
  Json json = Json::object();
  for (const auto& [type, s] : statistics) {
    json[type] = {{"count", s.count},
                  {"dimension", s.dimension},
                  {"mean_squared_whitened", Number(s.MeanSquare())}};
  }
  return json;
}

// Without wall times: equal runs give equal bytes.
Json RowJson(const HonestyRow& row) {
  return {{"walks", row.walks},
          {"no_answer", row.no_answer},
          {"n", row.n},
          {"error_m", NumberJson(row.error_m)},
          {"nees_per_dimension", NumberJson(row.nees_per_dimension)},
          {"median_nees_per_dimension", Number(row.median_nees_per_dimension)},
          {"coverage50", NumberJson(row.coverage50)},
          {"coverage95", NumberJson(row.coverage95)},
          {"beyond_999", Number(row.beyond_999)},
          {"residuals", StatisticsJson(row.statistics)},
          {"innovations", StatisticsJson(row.innovations)}};
}

}  // namespace

std::string FormatHonesty(const HonestyResult& result) {
  const std::vector<HonestyRow> rows = Rows(result);
  return FormatCovariances(rows) + "\n" + FormatResiduals(result, rows);
}

std::string FormatHonestyJson(const HonestyResult& result, const std::string& command_line) {
  Json json = {{"version", Version()},
               {"command_line", command_line},
               {"methods", Json::object()},
               {"residuals_at_truth", StatisticsJson(result.at_truth)}};
  for (const HonestyRow& row : Rows(result)) json["methods"][row.method] = RowJson(row);
  return json.dump(2) + "\n";
}

std::string FormatHonestyCsv(const HonestyResult& result) {
  std::string text = "method,walk,node,error_m,nees\n";
  for (std::size_t m = 0; m < result.methods.size(); ++m) {
    for (std::size_t w = 0; w < result.walks.size(); ++w) {
      const std::vector<WaypointError>& errors = result.outcomes[m][w].errors;
      for (std::size_t i = 0; i < errors.size(); ++i) {
        std::array<char, 80> numbers;
        std::snprintf(numbers.data(), numbers.size(), ",%zu,%.4f,%.4f\n", i, errors[i].error_m,
                      errors[i].nees);
        text += result.methods[m] + "," + result.walks[w] + numbers.data();
      }
    }
  }
  return text;
}

}  // namespace walkgraph
