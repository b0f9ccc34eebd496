#ifndef WALKGRAPH_SOLVERS_ESTIMATOR_H_
#define WALKGRAPH_SOLVERS_ESTIMATOR_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "data/trajectory.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

enum class EstimateStatus : std::uint8_t {
  kOk,
  kUnobservable,  // a trajectory from what there is, with honest, large covariance
  kUnsupported,   // the walk lacks what the method needs; messages say what
  kInputError,    // the recording could not be read
  kDiverged,      // no finite answer
};

// "ok", "unobservable", "unsupported", "input_error", "diverged".
inline std::string_view StatusName(EstimateStatus status) {
  constexpr std::string_view kNames[] = {"ok", "unobservable", "unsupported", "input_error",
                                         "diverged"};
  return kNames[static_cast<int>(status)];
}

// A slow state at a knot.
struct SlowStateEstimate {
  std::string name;  // with its unit: "gyro_bias_radps"
  TimeNs time_ns = 0;
  double value = 0;
  double sigma = 0;
};

// How well one factor type agreed with the solution.
struct FactorStatistics {
  std::string factor;
  std::int64_t count = 0;
  int dimension = 0;
  double mean_squared_whitened = 0;  // per dimension; about 1 where the noise model is right
  std::int64_t downweighted = 0;     // factors whose robust weight fell under 1/2
};

// How well one factor agreed with the solution: a scan's readings together.
struct FactorResidual {
  std::string factor;
  TimeNs time_ns = 0;
  int count = 0;                     // measurements
  double mean_squared_whitened = 0;  // per dimension
  int downweighted = 0;              // measurements whose robust weight fell under 1/2
};

// A competing explanation of the walk.
struct Hypothesis {
  std::string source;                   // "viterbi", "dead_reckoning 3"
  double negative_log_posterior = 0;    // with normalisers and 1/2 log det of the Hessian, nats
  bool kept = false;                    // within the mode limit of the best
  std::vector<Eigen::Vector2d> path_m;  // one point per node
};

struct EstimateResult {
  EstimateStatus status = EstimateStatus::kOk;
  Trajectory trajectory;
  std::vector<SlowStateEstimate> slow_states;
  std::vector<FactorStatistics> factor_statistics;
  // Of the readings of each factor type, where the method was asked for them: normalised innovation
  // squared in the place of squared residuals.
  std::vector<FactorStatistics> innovations;
  std::vector<FactorResidual> residuals;  // of the best hypothesis, in the graph's order
  std::vector<Hypothesis> hypotheses;     // best first
  std::vector<std::string> messages;
};

// A method that finds a walk. Implementations are immutable after construction, so that one object
// serves walks on several threads; equal input gives equal bytes.
class Estimator {
 public:
  virtual ~Estimator() = default;
  virtual std::string_view name() const = 0;
  // Never throws on poor evidence: that is what the status is for.
  virtual EstimateResult Estimate(const Site& site, const Evidence& evidence) const = 0;

  // Methods that ask what a perfect sensor would be worth: they are told where the walk went and
  // are no competitors. Everybody else is never shown it.
  virtual bool uses_truth() const { return false; }
  // Such a method on a walk of known positions (building axes; empty where none are known).
  virtual EstimateResult EstimateKnowing(const Trajectory& /*truth*/, const Site& site,
                                         const Evidence& evidence) const {
    return Estimate(site, evidence);
  }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_ESTIMATOR_H_
