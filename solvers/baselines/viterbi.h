#ifndef WALKGRAPH_SOLVERS_BASELINES_VITERBI_H_
#define WALKGRAPH_SOLVERS_BASELINES_VITERBI_H_

#include "factors/settings.h"
#include "solvers/baselines/discrete_smoother.h"
#include "solvers/estimator.h"

namespace walkgraph {

// Our own best discrete smoother: the most probable path of SmoothOnLattice() on the floors of
// TrackFloors() where none is given. No covariance. A walk without any absolute position is laid from the
// middle of the survey as dead reckoning has it, status `unobservable`.
class Viterbi : public Estimator {
 public:
  Viterbi(const FactorSettings& factors, const DiscreteSettings& settings)
      : factors_(factors), settings_(settings) {}

  std::string_view name() const override { return "viterbi"; }
  EstimateResult Estimate(const Site& site, const Evidence& evidence) const override;

 private:
  FactorSettings factors_;
  DiscreteSettings settings_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_VITERBI_H_
