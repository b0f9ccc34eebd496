#include "eval/study/study_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "eval/statistics/shapley.h"
#include "eval/study/breakdown.h"
#include "eval/survey_distance.h"

namespace walkgraph {
namespace {

using Walks = std::vector<const WalkCells*>;

WalkTotal TotalOf(const std::vector<WaypointError>& errors) {
  WalkTotal total;
  for (const WaypointError& error : errors) total.sum += error.error_m;
  total.n = static_cast<int>(errors.size());
  return total;
}

std::vector<WalkTotal> TotalsOf(const Walks& walks, std::size_t cell) {
  std::vector<WalkTotal> totals;
  for (const WalkCells* walk : walks) totals.push_back(TotalOf(ScoredErrors(*walk, cell)));
  return totals;
}

Correlation CorrelateClaims(const std::vector<WaypointError>& errors) {
  std::vector<double> claimed, made;
  for (const WaypointError& error : errors) {
    claimed.push_back(error.claimed_m);
    made.push_back(error.error_m);
  }
  return Correlate(claimed, made);
}

ComparedWithReference Compare(const std::vector<WalkTotal>& cell,
                              const std::vector<WalkTotal>& reference) {
  std::vector<WalkTotal> differences = cell;
  std::vector<double> of_means;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    differences[i].sum -= reference[i].sum;
    of_means.push_back(differences[i].sum / differences[i].n);
  }
  return {PooledMean(differences), BootstrapMean(differences), TestSignedRanks(of_means),
          std::numeric_limits<double>::quiet_NaN()};
}

CellStatistics StatisticsOf(const Walks& walks, std::size_t cell,
                            const std::vector<WalkTotal>& totals) {
  std::vector<WaypointError> pooled;
  for (const WalkCells* walk : walks) {
    const std::vector<WaypointError>& errors = ScoredErrors(*walk, cell);
    pooled.insert(pooled.end(), errors.begin(), errors.end());
  }
  CellStatistics statistics;
  statistics.walks = static_cast<int>(walks.size());
  statistics.errors = Summarise(pooled);
  statistics.mean_interval_m = BootstrapMean(totals);
  statistics.claimed = CorrelateClaims(pooled);
  return statistics;
}

StudySection MakeSection(const std::string& name, const Walks& walks, std::size_t cells,
                         std::size_t reference) {
  StudySection section{name, {}};
  const std::vector<WalkTotal> reference_totals = TotalsOf(walks, reference);
  std::vector<double> p_values;
  for (std::size_t c = 0; c < cells; ++c) {
    const std::vector<WalkTotal> totals = TotalsOf(walks, c);
    section.cells.push_back(StatisticsOf(walks, c, totals));
    if (c != reference) section.cells.back().compared = Compare(totals, reference_totals);
    p_values.push_back(section.cells.back().compared.test.p_value);
  }
  const std::vector<double> corrected = HolmCorrected(p_values);
  for (std::size_t c = 0; c < cells; ++c) section.cells[c].compared.corrected_p = corrected[c];
  return section;
}

bool AllPlaced(const WalkCells& walk) {
  return std::none_of(walk.cells.begin(), walk.cells.end(),
                      [](const CellResult& cell) { return cell.errors.empty(); });
}

std::vector<FactorContribution> ContributionsOf(const Walks& walks, const StudyRecord& record) {
  const std::size_t subsets = std::size_t{1} << record.factors.size();
  if (record.factors.empty() || record.cell_of_subset.size() != subsets) return {};
  // The value is linear in the walks' sums, so that each walk has a contribution of its own.
  std::vector<std::vector<WalkTotal>> removed(record.factors.size());
  for (const WalkCells* walk : walks) {
    std::vector<double> values;
    for (const auto& [subset, cell] : record.cell_of_subset) {
      values.push_back(-TotalOf(ScoredErrors(*walk, cell)).sum);
    }
    const auto shares = ShapleyValues(values, static_cast<int>(record.factors.size()));
    for (std::size_t f = 0; f < shares.size(); ++f) {
      removed[f].push_back({shares[f], static_cast<int>(walk->waypoints.size())});
    }
  }
  std::vector<FactorContribution> contributions;
  for (std::size_t f = 0; f < removed.size(); ++f) {
    contributions.push_back({record.factors[f], PooledMean(removed[f]), BootstrapMean(removed[f])});
  }
  return contributions;
}

std::vector<std::map<std::string, int>> CountStatus(const std::vector<WalkCells>& walks,
                                                    std::size_t cells) {
  std::vector<std::map<std::string, int>> counts(cells);
  for (const WalkCells& walk : walks) {
    for (std::size_t c = 0; c < cells; ++c) {
      ++counts[c][std::string(StatusName(walk.cells[c].status))];
    }
  }
  return counts;
}

DatasetStatistics StatisticsOf(const DatasetResults& dataset, const StudyRecord& record) {
  Walks all, covered, placed;
  for (const WalkCells& walk : dataset.walks) {
    if (walk.waypoints.empty()) continue;
    all.push_back(&walk);
    if (walk.survey_distance_m < kCoveredDistanceM) covered.push_back(&walk);
    if (AllPlaced(walk)) placed.push_back(&walk);
  }
  const std::size_t cells = record.cells.size(), reference = ReferenceCell(record);
  return {
      dataset.name,
      {MakeSection("all", all, cells, reference), MakeSection("covered", covered, cells, reference),
       MakeSection("placed", placed, cells, reference)},
      BreakDown(all, cells),
      ContributionsOf(all, record),
      CountStatus(dataset.walks, cells)};
}

}  // namespace

std::vector<DatasetStatistics> ComputeStatistics(const StudyResults& results) {
  std::vector<DatasetStatistics> statistics;
  for (const DatasetResults& dataset : results.datasets) {
    statistics.push_back(StatisticsOf(dataset, results.record));
  }
  return statistics;
}

}  // namespace walkgraph
