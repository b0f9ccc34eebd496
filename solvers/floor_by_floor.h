#ifndef WALKGRAPH_SOLVERS_FLOOR_BY_FLOOR_H_
#define WALKGRAPH_SOLVERS_FLOOR_BY_FLOOR_H_

#include <memory>
#include <string_view>
#include <utility>

#include "factors/settings.h"
#include "solvers/estimator.h"

namespace walkgraph {

// A method that knows one floor, on walks that see several: it is run on every stay of the floors
// that TrackFloors finds, as `viterbi` and the graph have them, and starts anew at each. Between
// two stays the trajectory is linear in time. Walks on one floor are given to it as they are.
class FloorByFloor : public Estimator {
 public:
  FloorByFloor(std::unique_ptr<Estimator> method, const FactorSettings& factors)
      : method_(std::move(method)), factors_(factors) {}

  std::string_view name() const override { return method_->name(); }
  // `ok` if the method found its way on any stay, else what it says of the whole walk on the floor
  // of the longest one.
  EstimateResult Estimate(const Site& site, const Evidence& evidence) const override;

 private:
  std::unique_ptr<Estimator> method_;
  FactorSettings factors_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_FLOOR_BY_FLOOR_H_
