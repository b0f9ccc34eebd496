#include "solvers/window_smoother.h"

#include <cmath>
#include <string>

#include "factors/stair_steps.h"
#include "graph/statistics.h"
#include "solvers/baselines/floor_tracker.h"
#include "solvers/describe.h"
#include "solvers/evidence_order.h"
#include "solvers/floor_states.h"
#include "solvers/window_run.h"

namespace walkgraph {

EstimateResult WindowSmoother::Estimate(const Site& site, const Evidence& unsorted) const {
  Evidence evidence = InCanonicalOrder(unsorted);
  // What is known of a node's floor when the node is reported.
  const double lag_s = window_.report_newest ? 0.0 : window_.seconds;
  const FloorTrack track = TrackFloors(site, evidence, factors_, lag_s);
  ShortenStairSteps(track.path, factors_.step, &evidence);
  WindowRun run(site, evidence, factors_, solver_, window_, track.path);
  run.Play();
  EstimateResult result = Describe(run.walk(), {run.reported()}, solver_.mode_limit_nats);
  AppendFloorStates(track, &result.slow_states);
  result.innovations = ToFactorStatistics(PoolByType(run.innovations()));
  if (run.waited_s() > 1.0) {
    result.messages.push_back("waited " + std::to_string(std::lround(run.waited_s())) +
                              " s more than its length for the walk to be located");
  }
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
