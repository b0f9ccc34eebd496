#include "solvers/window_smoother.h"

#include <map>
#include <string>
#include <vector>

#include "solvers/baselines/floor_tracker.h"
#include "solvers/describe.h"
#include "solvers/evidence_order.h"
#include "solvers/floor_states.h"
#include "solvers/window_run.h"

namespace walkgraph {
namespace {

std::vector<FactorStatistics> PoolByType(const std::vector<Innovation>& innovations) {
  std::map<std::string, FactorStatistics> by_type;
  for (const Innovation& innovation : innovations) {
    FactorStatistics& pooled = by_type[innovation.type];
    pooled.factor = innovation.type;
    pooled.count += innovation.count;
    pooled.dimension = innovation.dimension;
    pooled.mean_squared_whitened += innovation.normalized_squared * innovation.count;
  }
  std::vector<FactorStatistics> all;
  for (auto& [type, pooled] : by_type) {
    pooled.mean_squared_whitened /= static_cast<double>(pooled.count);
    all.push_back(pooled);
  }
  return all;
}

}  // namespace

EstimateResult WindowSmoother::Estimate(const Site& site, const Evidence& unsorted) const {
  const Evidence evidence = InCanonicalOrder(unsorted);
  // What is known of a node's floor when the node is reported.
  const double lag_s = window_.report_newest ? 0.0 : window_.seconds;
  const FloorTrack track = TrackFloors(site, evidence, factors_, lag_s);
  WindowRun run(site, evidence, factors_, solver_, window_, track.path);
  run.Play();
  EstimateResult result = Describe(run.walk(), {run.reported()}, solver_.mode_limit_nats);
  AppendFloorStates(track, &result.slow_states);
  result.innovations = PoolByType(run.innovations());
  if (run.recoveries() > 0) {
    result.messages.push_back("lost the track and took it up elsewhere " +
                              std::to_string(run.recoveries()) + " times");
  }
  if (run.failed_solves() > 0) {
    result.messages.push_back(std::to_string(run.failed_solves()) +
                              " solves failed and kept the values before");
  }
  if (run.dropped_late() > 0) {
    result.messages.push_back(std::to_string(run.dropped_late()) +
                              " late factors dropped: their nodes had left the window");
  }
  return result;
}

}  // namespace walkgraph
