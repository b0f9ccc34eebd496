#ifndef WALKGRAPH_SOLVERS_MODES_H_
#define WALKGRAPH_SOLVERS_MODES_H_

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "graph/walk_graph.h"
#include "solvers/estimator.h"
#include "solvers/settings.h"

namespace walkgraph {

// What is known of a walk graph's variables at a point.
struct PointUncertainty {
  // Marginal covariance of each block of the graph; 0 x 0 for constant ones.
  std::vector<Eigen::MatrixXd> covariance;
  double log_det_hessian = std::numeric_limits<double>::infinity();
  int variables = 0;  // coordinates
};

// The graph linearised at its values and solved for the covariance of every block. Where nothing
// tells the heading, the first one is taken as uniform on the circle (variance pi^2 / 3).
PointUncertainty ComputeUncertainty(const WalkGraph& walk);

// A local maximum of the posterior.
struct Mode {
  std::string source;
  Eigen::VectorXd values;  // of the graph
  double negative_log_density = 0;
  double negative_log_mass = 0;  // see NegativeLogModeMass
  PointUncertainty uncertainty;
};

// Drops modes whose positions are those of a denser one (within `distinct_m`, RMS over nodes), adds
// mass and covariance to the rest, and sorts them by mass, best first.
void RankModes(const SolverSettings& settings, WalkGraph* walk, std::vector<Mode>* modes);

// The mixture of all modes within the limit of the first: poses at the best mode, covariance about
// them. `floor_height_m` becomes z.
Trajectory MixModes(const WalkGraph& walk, const std::vector<Mode>& modes, double mode_limit_nats,
                    double floor_height_m);

// Slow states of a mode at their knots, constant ones left out.
std::vector<SlowStateEstimate> SlowStates(const WalkGraph& walk, const Mode& mode);

std::vector<Hypothesis> Hypotheses(const WalkGraph& walk, const std::vector<Mode>& modes,
                                   double mode_limit_nats);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_MODES_H_
