#ifndef WALKGRAPH_SOLVERS_BATCH_SMOOTHER_H_
#define WALKGRAPH_SOLVERS_BATCH_SMOOTHER_H_

#include <string_view>

#include "factors/settings.h"
#include "solvers/estimator.h"
#include "solvers/settings.h"

namespace walkgraph {

// `batch`: the whole walk at once. Every proposed start is refined by the same factor graph; the
// solutions are compared by the posterior mass of their modes, and those within
// mode_limit_nats of the best make the covariance. Where no floor is given the
// floors are those of TrackFloors. Where nothing says where the walk is, the answer is dead
// reckoning about the middle of the floor with the prior's covariance, status `unobservable`.
class BatchSmoother : public Estimator {
 public:
  // Throws std::invalid_argument on factor settings out of range, when first used.
  BatchSmoother(const FactorSettings& factors, const SolverSettings& solver)
      : factors_(factors), solver_(solver) {}

  std::string_view name() const override { return "batch"; }
  EstimateResult Estimate(const Site& site, const Evidence& evidence) const override;

 private:
  FactorSettings factors_;
  SolverSettings solver_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BATCH_SMOOTHER_H_
