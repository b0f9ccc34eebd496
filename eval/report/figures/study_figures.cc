#include "eval/report/figures/study_figures.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstddef>
#include <set>

namespace walkgraph {
namespace {

constexpr std::size_t kMostSeries = 20;

std::vector<std::size_t> CellsToDraw(const StudyRecord& record) {
  std::vector<std::size_t> order;
  std::set<std::size_t> taken, subsets;
  for (const auto& [subset, cell] : record.cell_of_subset) subsets.insert(cell);
  const auto take = [&](std::size_t cell) {
    if (order.size() < kMostSeries && taken.insert(cell).second) order.push_back(cell);
  };
  if (record.cells.size() > kMostSeries) {
    take(ReferenceCell(record));
    for (const auto& [subset, cell] : record.cell_of_subset) {
      if (static_cast<std::size_t>(std::popcount(subset)) + 1 == record.factors.size()) take(cell);
    }
  }
  const bool small = record.cells.size() <= kMostSeries;
  for (std::size_t c = 0; c < record.cells.size(); ++c) {
    if (small || !subsets.contains(c)) take(c);
  }
  return order;
}

FigureSeries SeriesOf(const StudyRecord& record, const DatasetResults& results,
                      const DatasetStatistics& statistics,
                      const std::map<std::string, double>& seconds, std::size_t cell) {
  const CellStatistics& all = statistics.sections.front().cells[cell];
  FigureSeries series;
  series.name = record.cells[cell].name;
  series.walks = all.walks;
  series.mean_m = all.errors.mean_m;
  series.mean_interval_m = all.mean_interval_m;
  for (const WalkCells& walk : results.walks) {
    const std::vector<WaypointError>& errors = ScoredErrors(walk, cell);
    series.errors.insert(series.errors.end(), errors.begin(), errors.end());
  }
  const auto found = seconds.find(series.name);
  if (found != seconds.end()) series.seconds_per_walk = found->second;
  return series;
}

// A row per subset, best first: a full dot for each factor that it has, in the order of the axis
// label, and its mean error. Subsets that never know a position are all the same row.
Figure AblationFigure(const StudyRecord& record, const DatasetStatistics& statistics) {
  std::vector<FigureBar> bars;
  int unobservable = 0;
  for (const auto& [subset, cell] : record.cell_of_subset) {
    const CellStatistics& all = statistics.sections.front().cells[cell];
    const bool placed = statistics.status[cell].contains("ok");
    if (!placed && unobservable++ > 0) continue;
    FigureBar bar{"no position known", all.errors.mean_m, all.mean_interval_m};
    if (placed) {
      bar.name.clear();
      for (std::size_t f = 0; f < record.factors.size(); ++f) {
        bar.name += (subset >> f & 1) != 0 ? "\u25cf " : "\u25cb ";
      }
    }
    bars.push_back(bar);
  }
  std::stable_sort(bars.begin(), bars.end(),
                   [](const FigureBar& a, const FigureBar& b) { return a.value < b.value; });
  std::string factors;
  for (const std::string& factor : record.factors)
    factors += (factors.empty() ? "" : ", ") + factor;
  const int walks = statistics.sections.front().cells.front().walks;
  return BarsFigure("ablation",
                    "Mean error with 95 % interval by subset (" + std::to_string(walks) +
                        " walks, " + std::to_string(unobservable) + " subsets know no position)",
                    "mean error, m", bars, "dots, from the left: " + factors);
}

Figure ContributionsFigure(const DatasetStatistics& statistics) {
  std::vector<FigureBar> bars;
  for (const FactorContribution& factor : statistics.contributions) {
    bars.push_back({factor.factor, factor.removes_m, factor.interval_m});
  }
  const int walks = statistics.sections.front().cells.front().walks;
  return BarsFigure("contributions",
                    "What each factor takes off the mean error (Shapley values, " +
                        std::to_string(walks) + " walks)",
                    "m", bars);
}

// The reference's mean error by distance walked, floor, phone and the other classes.
Figure BreakdownFigure(const StudyRecord& record, const DatasetStatistics& statistics) {
  const std::size_t reference = ReferenceCell(record);
  std::vector<FigureBar> bars;
  for (const BreakdownRow& row : statistics.breakdown) {
    bars.push_back({row.by + ": " + row.value + " (" + std::to_string(row.walks) + " walks)",
                    row.cells[reference].mean_m,
                    {}});
  }
  return BarsFigure("breakdown", "Where " + record.reference + " errs", "mean error, m", bars);
}

// A curve per setting that a grid ran over with a single numeric key.
std::vector<Figure> CurveFigures(const StudyRecord& record, const DatasetStatistics& statistics) {
  std::map<std::string, std::map<std::string, FigureCurve>> by_key;  // by key, then method
  for (std::size_t c = 0; c < record.cells.size(); ++c) {
    const StudyCellRecord& cell = record.cells[c];
    if (cell.overrides.size() != 1) continue;
    const auto& [key, text] = *cell.overrides.begin();
    double value = 0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size()) continue;
    const CellStatistics& all = statistics.sections.front().cells[c];
    FigureCurve& curve = by_key[key][cell.method];
    curve.name = cell.method;
    curve.points.push_back({value, {"", all.errors.mean_m, all.mean_interval_m}});
  }
  std::vector<Figure> figures;
  for (auto& [key, by_method] : by_key) {
    std::vector<FigureCurve> curves;
    for (auto& [method, curve] : by_method) {
      std::sort(curve.points.begin(), curve.points.end(),
                [](const auto& a, const auto& b) { return a.first < b.first; });
      if (curve.points.size() > 1) curves.push_back(curve);
    }
    if (curves.empty()) continue;
    figures.push_back(
        CurveFigure("curve_" + key, key, curves, statistics.sections.front().cells.front().walks));
  }
  return figures;
}

}  // namespace

std::vector<Figure> StudyFigures(const StudyRecord& record, const DatasetResults& results,
                                 const DatasetStatistics& statistics,
                                 const std::map<std::string, double>& seconds) {
  std::vector<FigureSeries> drawn, others;
  std::set<std::size_t> subsets;
  for (const auto& [subset, cell] : record.cell_of_subset) subsets.insert(cell);
  for (const std::size_t c : CellsToDraw(record)) {
    drawn.push_back(SeriesOf(record, results, statistics, seconds, c));
  }
  for (std::size_t c = 0; c < record.cells.size(); ++c) {
    if (subsets.contains(c)) continue;
    const CellStatistics& cell = statistics.sections.front().cells[c];
    others.push_back({record.cells[c].name,
                      cell.walks,
                      {},
                      cell.errors.mean_m,
                      cell.mean_interval_m,
                      std::numeric_limits<double>::quiet_NaN()});
  }
  std::vector<Figure> figures;
  if (!record.cell_of_subset.empty()) figures.push_back(AblationFigure(record, statistics));
  if (!statistics.contributions.empty()) figures.push_back(ContributionsFigure(statistics));
  if (record.cell_of_subset.size() < record.cells.size()) figures.push_back(MeansFigure(others));
  figures.push_back(ErrorDistributionFigure(drawn));
  figures.push_back(BoxFigure(drawn));
  figures.push_back(CalibrationFigure(drawn));
  if (!seconds.empty()) figures.push_back(TimeFigure(drawn));
  figures.push_back(BreakdownFigure(record, statistics));
  for (Figure& curve : CurveFigures(record, statistics)) figures.push_back(std::move(curve));
  return figures;
}

}  // namespace walkgraph
