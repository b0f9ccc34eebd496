#include "eval/honesty/honesty_figures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "eval/report/figures/plot.h"

namespace walkgraph {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// The methods that gave covariances.
struct Shown {
  std::vector<FigureSeries> series;
  std::vector<HonestyRow> rows;
  std::vector<std::vector<double>> nees_by_walk;  // per dimension, ascending
};

std::vector<double> NeesByWalk(const std::vector<WalkHonesty>& walks) {
  std::vector<double> by_walk;
  for (const WalkHonesty& walk : walks) {
    double sum = 0;
    int count = 0;
    for (const WaypointError& error : walk.errors) {
      if (!std::isfinite(error.nees)) continue;
      sum += error.nees / 2;
      ++count;
    }
    if (count > 0) by_walk.push_back(sum / count);
  }
  std::sort(by_walk.begin(), by_walk.end());
  return by_walk;
}

Shown Collect(const HonestyResult& result) {
  Shown shown;
  for (std::size_t m = 0; m < result.methods.size(); ++m) {
    std::vector<double> nees = NeesByWalk(result.outcomes[m]);
    if (nees.empty()) continue;
    FigureSeries series;
    series.name = result.methods[m];
    for (const WalkHonesty& walk : result.outcomes[m]) {
      series.walks += walk.errors.empty() ? 0 : 1;
      series.errors.insert(series.errors.end(), walk.errors.begin(), walk.errors.end());
    }
    shown.series.push_back(std::move(series));
    shown.rows.push_back(SummariseHonesty(result.methods[m], result.outcomes[m]));
    shown.nees_by_walk.push_back(std::move(nees));
  }
  return shown;
}

std::string OverWalks(const Shown& shown) {
  return " (" + std::to_string(shown.series.front().walks) + " walks)";
}

Figure NeesFigure(const Shown& shown) {
  std::vector<FigureBar> bars;
  for (const HonestyRow& row : shown.rows) {
    bars.push_back({row.method, row.nees_per_dimension.mean, row.nees_per_dimension.interval});
  }
  return BarsFigure("nees", "NEES per dimension with 95 % interval; honest is 1" + OverWalks(shown),
                    "NEES per dimension", bars);
}

Figure NeesByWalkFigure(const Shown& shown) {
  Plot plot("Share of walks below a mean NEES per dimension" + OverWalks(shown), 620, 320);
  double low = 0.1, high = 10;
  for (const std::vector<double>& nees : shown.nees_by_walk) {
    low = std::min(low, std::max(nees.front(), 1e-3));
    high = std::max(high, nees.back());
  }
  plot.DrawAxes({"mean NEES per dimension of a walk", low, high, true}, {"share", 0, 1, false});
  plot.Segment({1, 0}, {1, 1}, "currentColor", 1);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < shown.series.size(); ++i) {
    const std::vector<double>& nees = shown.nees_by_walk[i];
    std::vector<Eigen::Vector2d> points;
    for (std::size_t w = 0; w < nees.size(); ++w) {
      points.emplace_back(std::max(nees[w], low),
                          static_cast<double>(w + 1) / static_cast<double>(nees.size()));
    }
    plot.Line(points, StyleOf(i));
    names.push_back(shown.series[i].name);
  }
  plot.Legend(names);
  return {"nees_by_walk", plot.Svg()};
}

Figure ResidualsFigure(const HonestyResult& result, const Shown& shown) {
  std::vector<FigureBar> bars;
  const auto add = [&bars](const std::string& where, const StatisticsByType& statistics) {
    for (const auto& [type, pooled] : statistics) {
      bars.push_back({type + ", " + where, pooled.MeanSquare(), {kNan, kNan}});
    }
  };
  add("at truth", result.at_truth);
  for (const HonestyRow& row : shown.rows) {
    add(row.method, row.statistics);
    add(row.method + " innovation", row.innovations);
  }
  return BarsFigure(
      "residuals",
      "Mean squared whitened residuals; at the truth, and of innovations, 1" + OverWalks(shown),
      "mean square", bars);
}

}  // namespace

std::vector<Figure> HonestyFigures(const HonestyResult& result) {
  const Shown shown = Collect(result);
  if (shown.series.empty()) return {};
  return {CalibrationFigure(shown.series), NeesFigure(shown), NeesByWalkFigure(shown),
          ResidualsFigure(result, shown)};
}

std::string FormatHonestyPage(const std::vector<Figure>& figures) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>Honesty</title>\n"
      "<style>:root{color-scheme:light dark}body{font-family:sans-serif;margin:1rem}"
      "svg{max-width:100%;height:auto}</style>\n</head>\n<body>\n<h1>Are the covariances "
      "honest?</h1>\n"
      "<p>Scored is one node per 20 s. The numbers stand in honesty.json and honesty.csv.</p>\n";
  for (const Figure& figure : figures) page += "<figure>" + figure.svg + "</figure>\n";
  return page + "</body>\n</html>\n";
}

}  // namespace walkgraph
