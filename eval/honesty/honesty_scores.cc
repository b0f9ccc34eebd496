#include "eval/honesty/honesty_scores.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>

#include "data/time.h"

namespace walkgraph {
namespace {

using ErrorValue = std::function<double(const WaypointError&)>;

MeanWithInterval PooledOverWalks(const std::vector<WalkHonesty>& walks, const ErrorValue& value) {
  std::vector<WalkTotal> totals;
  for (const WalkHonesty& walk : walks) {
    WalkTotal total;
    for (const WaypointError& error : walk.errors) {
      total.sum += value(error);
      ++total.n;
    }
    if (total.n > 0) totals.push_back(total);
  }
  return {PooledMean(totals), BootstrapMean(totals)};
}

ErrorValue InsideEllipse(double probability) {
  return [limit = ChiSquare2Quantile(probability)](const WaypointError& error) {
    return error.nees <= limit ? 1.0 : 0.0;
  };
}

double MedianNees(const std::vector<WalkHonesty>& walks) {
  std::vector<double> nees;
  for (const WalkHonesty& walk : walks) {
    for (const WaypointError& error : walk.errors) nees.push_back(error.nees);
  }
  if (nees.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(nees.begin(), nees.end());
  return Quantile(nees, 0.5);
}

}  // namespace

Truth ThinTruth(const Truth& truth, double every_s) {
  Truth thinned;
  thinned.frame = truth.frame;
  const std::vector<Waypoint>& all = truth.waypoints;
  if (all.empty()) return thinned;
  std::size_t nearest = 0;
  std::size_t next = 0;  // the first that has not been taken
  for (double due_s = 0.5 * every_s;; due_s += every_s) {
    const TimeNs due_ns = all.front().time_ns + DurationNs(due_s);
    if (due_ns > all.back().time_ns) return thinned;
    const auto off = [&](std::size_t i) {
      return std::abs(SecondsBetween(due_ns, all[i].time_ns));
    };
    while (nearest + 1 < all.size() && off(nearest + 1) <= off(nearest)) ++nearest;
    if (nearest < next) continue;
    thinned.waypoints.push_back(all[nearest]);
    next = nearest + 1;
  }
}

void PooledStatistics::Add(std::int64_t more, int rows, double mean_squared_whitened) {
  count += more;
  dimension = rows;
  sum += mean_squared_whitened * static_cast<double>(more) * rows;
}

double PooledStatistics::MeanSquare() const {
  return sum / (static_cast<double>(count) * dimension);
}

HonestyRow SummariseHonesty(const std::string& method, const std::vector<WalkHonesty>& walks) {
  HonestyRow row;
  row.method = method;
  for (const WalkHonesty& walk : walks) {
    ++(walk.has_trajectory ? row.walks : row.no_answer);
    row.n += static_cast<int>(walk.errors.size());
    row.seconds_per_walk += walk.seconds / static_cast<double>(walks.size());
    for (const FactorStatistics& s : walk.statistics) {
      row.statistics[s.factor].Add(s.count, s.dimension, s.mean_squared_whitened);
    }
    for (const FactorStatistics& s : walk.innovations) {
      row.innovations[s.factor].Add(s.count, s.dimension, s.mean_squared_whitened);
    }
  }
  row.error_m = PooledOverWalks(walks, [](const WaypointError& e) { return e.error_m; });
  row.nees_per_dimension =
      PooledOverWalks(walks, [](const WaypointError& e) { return 0.5 * e.nees; });
  row.median_nees_per_dimension = 0.5 * MedianNees(walks);
  row.coverage50 = PooledOverWalks(walks, InsideEllipse(0.5));
  row.coverage95 = PooledOverWalks(walks, InsideEllipse(0.95));
  row.beyond_999 = 1.0 - PooledOverWalks(walks, InsideEllipse(0.999)).mean;
  return row;
}

}  // namespace walkgraph
