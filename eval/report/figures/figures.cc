#include "eval/report/figures/figures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "eval/report/figures/plot.h"

namespace walkgraph {
namespace {

constexpr int kWidth = 560, kHeight = 300, kRowHeight = 20, kRowLabels = 300;
constexpr double kNarrow = 1.2, kWide = 5;

std::string RestsOn(const std::vector<FigureSeries>& series) {
  std::size_t n = 0;
  int walks = 0;
  for (const FigureSeries& s : series) {
    n = std::max(n, s.errors.size());
    walks = std::max(walks, s.walks);
  }
  const std::string waypoints = n == 0 ? "" : ", " + std::to_string(n) + " waypoints";
  return " (" + std::to_string(walks) + (walks == 1 ? " walk" : " walks") + waypoints + ")";
}

std::vector<double> SortedErrors(const FigureSeries& series) {
  std::vector<double> sorted;
  for (const WaypointError& error : series.errors) sorted.push_back(error.error_m);
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

std::vector<std::string> NamesOf(const std::vector<FigureSeries>& series) {
  std::vector<std::string> names;
  names.reserve(series.size());
  for (const FigureSeries& s : series) names.push_back(s.name);
  return names;
}

double UpperEnd(double value) { return value > 0 ? 1.05 * value : 1.0; }

int RowsHeight(std::size_t rows) {
  return kRowHeight * static_cast<int>(std::max<std::size_t>(rows, 2));
}

std::vector<double> SortedNees(const FigureSeries& series) {
  std::vector<double> sorted;
  for (const WaypointError& error : series.errors) {
    if (!std::isnan(error.nees)) sorted.push_back(error.nees);
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

void DrawInterval(const FigureBar& bar, double row, const std::string& colour, Plot* plot) {
  if (std::isnan(bar.interval.low)) return;
  plot->Segment({bar.interval.low, row}, {bar.interval.high, row}, colour, kNarrow);
}

}  // namespace

Figure ErrorDistributionFigure(const std::vector<FigureSeries>& series) {
  constexpr int kPoints = 120;
  Plot plot("Share of waypoints within an error" + RestsOn(series), kWidth, kHeight);
  double end = 0;
  for (const FigureSeries& s : series) {
    const std::vector<double> sorted = SortedErrors(s);
    if (!sorted.empty()) end = std::max(end, Quantile(sorted, 0.97));
  }
  plot.DrawAxes({"horizontal error, m", 0, UpperEnd(end), false}, {"share", 0, 1, false});
  for (std::size_t i = 0; i < series.size(); ++i) {
    const std::vector<double> sorted = SortedErrors(series[i]);
    std::vector<Eigen::Vector2d> points;
    for (int k = 0; k <= kPoints && !sorted.empty(); ++k) {
      const double x = UpperEnd(end) * k / kPoints;
      const auto within = std::upper_bound(sorted.begin(), sorted.end(), x) - sorted.begin();
      points.emplace_back(x, static_cast<double>(within) / static_cast<double>(sorted.size()));
    }
    plot.Line(points, StyleOf(i));
  }
  plot.Legend(NamesOf(series));
  return {"error_distribution", plot.Svg()};
}

Figure BoxFigure(const std::vector<FigureSeries>& series) {
  Plot plot("Errors: quartiles, mean, 5th to 95th percentile" + RestsOn(series), kWidth - 120,
            RowsHeight(series.size()), kRowLabels);
  double end = 0;
  for (const FigureSeries& s : series) {
    const std::vector<double> sorted = SortedErrors(s);
    if (!sorted.empty()) end = std::max(end, Quantile(sorted, 0.95));
  }
  plot.DrawRows({"horizontal error, m", 0, UpperEnd(end), false}, NamesOf(series));
  for (std::size_t i = 0; i < series.size(); ++i) {
    const std::vector<double> sorted = SortedErrors(series[i]);
    if (sorted.empty()) continue;
    const auto row = static_cast<double>(i);
    const SeriesStyle style = StyleOf(i);
    plot.Segment({Quantile(sorted, 0.05), row}, {Quantile(sorted, 0.95), row}, style.colour,
                 kNarrow);
    plot.Box({Quantile(sorted, 0.25), row - 0.32}, {Quantile(sorted, 0.75), row + 0.32},
             style.colour);
    const double median = Quantile(sorted, 0.5);
    plot.Segment({median, row - 0.32}, {median, row + 0.32}, style.colour, 2.5);
    if (series[i].mean_m <= UpperEnd(end)) plot.Marker({series[i].mean_m, row}, style);
  }
  return {"boxes", plot.Svg()};
}

Figure CalibrationFigure(const std::vector<FigureSeries>& series) {
  constexpr int kPoints = 40;
  Plot plot("Waypoints inside the ellipse of a probability" + RestsOn(series), 460, kHeight);
  plot.DrawAxes({"probability claimed", 0, 1, false}, {"share found inside", 0, 1, false});
  plot.Segment({0, 0}, {1, 1}, "currentColor", 1);
  std::vector<FigureSeries> shown;
  for (const FigureSeries& s : series) {
    const std::vector<double> sorted = SortedNees(s);
    if (sorted.empty()) continue;
    std::vector<Eigen::Vector2d> points;
    for (int k = 0; k < kPoints; ++k) {
      const double p = static_cast<double>(k) / kPoints;
      const auto inside =
          std::upper_bound(sorted.begin(), sorted.end(), ChiSquare2Quantile(p)) - sorted.begin();
      points.emplace_back(p, static_cast<double>(inside) / static_cast<double>(sorted.size()));
    }
    plot.Line(points, StyleOf(shown.size()));
    shown.push_back(s);
  }
  plot.Legend(NamesOf(shown));
  return {"calibration", plot.Svg()};
}

Figure TimeFigure(const std::vector<FigureSeries>& series) {
  double fastest = INFINITY, slowest = 0, end = 0;
  for (const FigureSeries& s : series) {
    if (!(s.seconds_per_walk > 0)) continue;
    fastest = std::min(fastest, s.seconds_per_walk);
    slowest = std::max(slowest, s.seconds_per_walk);
    end = std::max(end, s.mean_m);
  }
  Plot plot("Mean error against time per walk" + RestsOn(series), kWidth, kHeight);
  if (slowest == 0) fastest = slowest = 1;
  plot.DrawAxes({"wall time per walk, s", fastest / 2, slowest * 2, true},
                {"mean error, m", 0, UpperEnd(end), false});
  for (std::size_t i = 0; i < series.size(); ++i) {
    const FigureSeries& s = series[i];
    if (!(s.seconds_per_walk > 0)) continue;
    plot.Marker({s.seconds_per_walk, s.mean_m}, StyleOf(i));
    plot.Label({s.seconds_per_walk, s.mean_m}, s.name);
  }
  return {"time_accuracy", plot.Svg()};
}

Figure MeansFigure(const std::vector<FigureSeries>& series) {
  std::vector<FigureBar> bars;
  bars.reserve(series.size());
  for (const FigureSeries& s : series) bars.push_back({s.name, s.mean_m, s.mean_interval_m});
  return BarsFigure("means", "Mean error with 95 % interval" + RestsOn(series), "mean error, m",
                    bars);
}

Figure BarsFigure(const std::string& name, const std::string& title, const std::string& axis,
                  const std::vector<FigureBar>& bars, const std::string& heading) {
  double low = 0, high = 0;
  std::vector<std::string> names;
  for (const FigureBar& bar : bars) {
    names.push_back(bar.name);
    for (const double value : {bar.value, bar.interval.low, bar.interval.high}) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  Plot plot(title, kWidth - 120, RowsHeight(bars.size()), kRowLabels);
  const double margin = high > low ? 0.03 * (high - low) : 1.0;
  if (!heading.empty()) plot.Heading(heading);
  plot.DrawRows({axis, low - (low < 0 ? margin : 0), high + margin, false}, names);
  const double last = static_cast<double>(bars.size()) - 0.5;
  plot.Segment({0, -0.5}, {0, last}, "currentColor", 1);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const auto row = static_cast<double>(i);
    const SeriesStyle style = StyleOf(0);
    if (!std::isfinite(bars[i].value)) continue;
    plot.Segment({0, row}, {bars[i].value, row}, style.colour, kWide);
    DrawInterval(bars[i], row, "currentColor", &plot);
  }
  return {name, plot.Svg()};
}

Figure CurveFigure(const std::string& name, const std::string& setting,
                   const std::vector<FigureCurve>& curves, int walks) {
  double low = INFINITY, high = -INFINITY, end = 0;
  for (const FigureCurve& curve : curves) {
    for (const auto& [x, bar] : curve.points) {
      low = std::min(low, x);
      high = std::max(high, x);
      end = std::max({end, bar.value, std::isnan(bar.interval.high) ? 0 : bar.interval.high});
    }
  }
  Plot plot("Mean error by " + setting + " (" + std::to_string(walks) + " walks)", kWidth, kHeight);
  plot.DrawAxes({setting, low, high > low ? high : low + 1, false},
                {"mean error, m", 0, UpperEnd(end), false});
  std::vector<std::string> names;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    std::vector<Eigen::Vector2d> line;
    for (const auto& [x, bar] : curves[i].points) {
      line.emplace_back(x, bar.value);
      plot.Marker(line.back(), StyleOf(i));
      if (std::isnan(bar.interval.low)) continue;
      plot.Segment({x, bar.interval.low}, {x, bar.interval.high}, StyleOf(i).colour, kNarrow);
    }
    plot.Line(line, StyleOf(i));
    names.push_back(curves[i].name);
  }
  plot.Legend(names);
  return {name, plot.Svg()};
}

}  // namespace walkgraph
