#include "solvers/window_smoother.h"

#include <algorithm>
#include <string>
#include <vector>

#include "solvers/describe.h"
#include "solvers/evidence_order.h"
#include "solvers/floor_solution.h"
#include "solvers/floors.h"
#include "solvers/window_run.h"

namespace walkgraph {
namespace {

// The given floor, else the one that explains the first window best.
int ChooseFloor(const Site& site, const Evidence& evidence, const FactorSettings& factors,
                const SolverSettings& solver, const WindowSettings& window) {
  const std::vector<int> floors = CandidateFloors(site, evidence);
  if (floors.size() == 1) return floors.front();
  TimeNs until_ns = evidence.begin_ns + DurationNs(window.seconds);
  if (!evidence.readings.empty()) {
    until_ns = std::max(until_ns, evidence.readings.front().printed_ns);
  }
  return SolveFloors(site, EvidenceUntil(evidence, until_ns), factors, solver).front().walk.floor;
}

}  // namespace

EstimateResult WindowSmoother::Estimate(const Site& site, const Evidence& unsorted) const {
  const Evidence evidence = InCanonicalOrder(unsorted);
  const int floor = ChooseFloor(site, evidence, factors_, solver_, window_);
  WindowRun run(site, evidence, factors_, solver_, window_, floor);
  run.Play();
  EstimateResult result = Describe(site, run.walk(), {run.reported()}, solver_.mode_limit_nats);
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
