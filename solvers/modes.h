#ifndef WALKGRAPH_SOLVERS_MODES_H_
#define WALKGRAPH_SOLVERS_MODES_H_

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "data/time.h"
#include "graph/graph_part.h"
#include "graph/map_error_states.h"
#include "graph/walk_graph.h"
#include "solvers/estimator.h"
#include "solvers/initial_trajectory.h"
#include "solvers/settings.h"

namespace walkgraph {

// What is known of a walk graph's variables at a point.
struct PointUncertainty {
  // Marginal covariance of each block of the graph; 0 x 0 for constant ones,
  // NaN for those outside the part.
  std::vector<Eigen::MatrixXd> covariance;
  double log_det_hessian = std::numeric_limits<double>::infinity();
  int variables = 0;  // coordinates
};

// The part linearised at the graph's values and solved for the covariance of each of its blocks.
// Where nothing tells the heading, the part's first one is taken as uniform on the circle (variance
// pi^2 / 3).
//
// The map error is known from other walks alone. Where those of this walk are larger than its noise
// model allows (`map_error_test`, see SolverSettings), the covariance is that under the variance
// that they show; the Hessian, which compares modes, stays that of the model.
PointUncertainty ComputeUncertainty(const WalkGraph& walk, const GraphPart& part,
                                    double map_error_test);

// The same covariances where the errors of maps grow away from the survey (see WideningOfKnots),
// for what is reported: the mode, its mass and what tells it from others stay those of the model.
void WidenOffSurvey(const WalkGraph& walk, const GraphPart& part, double map_error_test,
                    PointUncertainty* uncertainty);

// A local maximum of the posterior.
struct Mode {
  std::string source;
  Eigen::VectorXd values;  // of the graph
  double negative_log_density = 0;
  double negative_log_mass = 0;  // see NegativeLogModeMass
  PointUncertainty uncertainty;
  MapErrorConditionals conditionals;  // of the maps' errors there
  std::vector<std::size_t> starts;    // indices of those that led to it, where FindModes found it
};

// Whether a point of the state space explains the walk as a mode does, `values` with `uncertainty`:
// positions within `distinct_m`, root mean square over the part's nodes, or within a sigma of the
// mode's own, which is much where a map's edge leaves the walk anywhere.
bool SamePath(const FactorGraph& graph, const GraphPart& part, const Eigen::VectorXd& point,
              const Eigen::VectorXd& values, const PointUncertainty& uncertainty,
              double distinct_m);

// Weights of a mixture, adding up to one, from the negative log masses (nats) of its parts. The
// first, which must be the smallest, has it all where they are not finite.
std::vector<double> MixtureWeights(const std::vector<double>& negative_log_masses);

// Drops modes whose positions are those of a denser one (within `distinct_m`, RMS over the
// part's nodes), which takes over their starts, adds mass and covariance to the rest, and sorts
// them by mass, best first.
void RankModes(const SolverSettings& settings, const GraphPart& part, WalkGraph* walk,
               std::vector<Mode>* modes);

// The mixture of all modes within the limit of the first: poses at the best mode, covariance about
// them. Where the graph has no heights z is the level's, without a variance.
Trajectory MixModes(const WalkGraph& walk, const std::vector<Mode>& modes, double mode_limit_nats);

// Solves the part of a walk's graph from one start and returns what it finds, without its mass. A
// solve that fails counts in `failed_solves` and leaves the start.
Mode SolveFrom(const InitialTrajectory& start, const GraphPart& part,
               const SolverSettings& settings, WalkGraph* walk, int* failed_solves);

// Takes the graph to a mode: its values, and the errors of maps conditioned as it has them.
void GoTo(const Mode& mode, WalkGraph* walk);

// A mode moved to where it is when the maps' errors belong to the places that it passed until
// `now_ns` (see ConditionOnPlaces): twice, for they change with it. Without its mass.
Mode RefineOnPlaces(Mode mode, const GraphPart& part, TimeNs now_ns, const SolverSettings& settings,
                    WalkGraph* walk, int* failed_solves);

// The modes that the starts lead to, best first, with the maps' errors on the places that each
// passed until `now_ns`. `part` is all of the walk's graph that is known by then.
std::vector<Mode> FindModes(const std::vector<InitialTrajectory>& starts, const GraphPart& part,
                            TimeNs now_ns, const SolverSettings& settings, WalkGraph* walk,
                            int* failed_solves);

// Slow states of a mode at their knots, constant ones left out. The barometric offset a second time
// in hPa: what this barometer shows at height zero, less the standard atmosphere's pressure.
std::vector<SlowStateEstimate> SlowStates(const WalkGraph& walk, const Mode& mode);

std::vector<Hypothesis> Hypotheses(const WalkGraph& walk, const std::vector<Mode>& modes,
                                   double mode_limit_nats);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_MODES_H_
