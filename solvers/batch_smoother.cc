#include "solvers/batch_smoother.h"

#include <string>
#include <utility>
#include <vector>

#include "solvers/describe.h"
#include "solvers/evidence_order.h"
#include "solvers/floor_solution.h"

namespace walkgraph {

EstimateResult BatchSmoother::Estimate(const Site& site, const Evidence& unsorted) const {
  const Evidence evidence = InCanonicalOrder(unsorted);
  std::vector<FloorSolution> solutions = SolveFloors(site, evidence, factors_, solver_);
  EstimateResult result =
      Describe(site, solutions.front().walk, solutions.front().modes, solver_.mode_limit_nats);
  for (const FloorSolution& solution : solutions) {
    if (solution.failed_solves > 0) {
      result.messages.push_back("floor " + std::to_string(solution.walk.floor) + ": " +
                                std::to_string(solution.failed_solves) +
                                " solves failed and kept their starts");
    }
    if (&solution == &solutions.front()) continue;
    for (Hypothesis& other : Hypotheses(solution.walk, solution.modes, 0)) {
      other.kept = false;
      result.hypotheses.push_back(std::move(other));
    }
  }
  return result;
}

}  // namespace walkgraph
