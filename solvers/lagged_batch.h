#ifndef WALKGRAPH_SOLVERS_LAGGED_BATCH_H_
#define WALKGRAPH_SOLVERS_LAGGED_BATCH_H_

#include "factors/settings.h"
#include "solvers/batch_smoother.h"
#include "solvers/estimator.h"
#include "solvers/settings.h"

namespace walkgraph {

// What a lag can know at most: every node as the whole-walk smoother has it from all evidence until
// the window's length after it, solved anew, with nothing marginalised and nothing linearised once
// for all. Too dear for a phone (a batch every two seconds of a walk): it is the measure that a
// window's own losses are told from those of not yet knowing what comes.
class LaggedBatch : public Estimator {
 public:
  LaggedBatch(const FactorSettings& factors, const SolverSettings& solver,
              const WindowSettings& window)
      : batch_(factors, solver), lag_s_(window.seconds) {}

  std::string_view name() const override { return "lagged_batch"; }
  // Slow states, statistics and hypotheses are those of the last solve, on everything.
  EstimateResult Estimate(const Site& site, const Evidence& evidence) const override;

 private:
  BatchSmoother batch_;
  double lag_s_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_LAGGED_BATCH_H_
