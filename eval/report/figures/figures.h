#ifndef WALKGRAPH_EVAL_REPORT_FIGURES_FIGURES_H_
#define WALKGRAPH_EVAL_REPORT_FIGURES_FIGURES_H_

#include <string>
#include <utility>
#include <vector>

#include "eval/bootstrap.h"
#include "eval/metrics.h"

namespace walkgraph {

// The errors of one method, or of one cell of a study, on the waypoints that are compared.
struct FigureSeries {
  std::string name;
  int walks = 0;
  std::vector<WaypointError> errors;
  double mean_m = 0;
  Interval mean_interval_m;
  double seconds_per_walk = std::numeric_limits<double>::quiet_NaN();
};

// A figure as SVG; `name` is that of its file.
struct Figure {
  std::string name;
  std::string svg;
};

// Every title says how many walks and waypoints the figure rests on. Series without errors are left
// out. Precondition of each: at least one series.

// Share of waypoints within an error.
Figure ErrorDistributionFigure(const std::vector<FigureSeries>& series);
// Quartiles with median and mean, whiskers from the 5th to the 95th percentile.
Figure BoxFigure(const std::vector<FigureSeries>& series);
// Share of waypoints inside the ellipse of each probability; the diagonal is an honest covariance.
Figure CalibrationFigure(const std::vector<FigureSeries>& series);
// Mean error against wall time per walk.
Figure TimeFigure(const std::vector<FigureSeries>& series);
// A row per series: mean error with its interval.
Figure MeansFigure(const std::vector<FigureSeries>& series);

// A named value with its interval: contributions of factors.
struct FigureBar {
  std::string name;
  double value = 0;
  Interval interval;
};
Figure BarsFigure(const std::string& name, const std::string& title, const std::string& axis,
                  const std::vector<FigureBar>& bars, const std::string& heading = "");

// Mean error against a setting's values.
struct FigureCurve {
  std::string name;
  std::vector<std::pair<double, FigureBar>> points;  // by value
};
Figure CurveFigure(const std::string& name, const std::string& setting,
                   const std::vector<FigureCurve>& curves, int walks);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_REPORT_FIGURES_FIGURES_H_
