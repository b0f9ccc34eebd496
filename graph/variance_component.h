#ifndef WALKGRAPH_GRAPH_VARIANCE_COMPONENT_H_
#define WALKGRAPH_GRAPH_VARIANCE_COMPONENT_H_

#include <vector>

#include "graph/linear_system.h"
#include "graph/marginal_covariance.h"

namespace walkgraph {

// What a solution says about the variance of a group of its residuals (Foerstner 1979, Ein
// Verfahren zur Schaetzung von Varianz- und Kovarianzkomponenten): their squares, and how many of
// them were free. A residual that the fit could choose says nothing: of n rows J it used up tr(J S
// J^T), S the covariance of the solution. Where the noise model is right, the squares are about
// chi-squared of `redundancy` degrees of freedom.
struct VarianceComponent {
  double squares = 0;
  double redundancy = 0;

  // What the group's variance is to be multiplied by: squares / redundancy where a chi-squared test
  // rejects the noise model at `level` (a probability, 0 < level < 1) because the residuals are too
  // large; else one. Groups with less than one degree of freedom are not tested.
  double Inflation(double level) const;
};

// Of the factors that touch blocks of the group alone. `in_group` says it by block of the system,
// `marginals` are those of the system.
VarianceComponent EstimateVarianceComponent(const LinearSystem& system,
                                            const std::vector<bool>& in_group,
                                            const MarginalCovariance& marginals);

// Multiplies the standard deviation of each block of the group, by block of the system, in the
// factors that touch blocks of the group alone.
void WidenBlocks(const std::vector<double>& ratio, const std::vector<bool>& in_group,
                 LinearSystem* system);

// Multiplies the variance of the same factors.
void InflateVariance(double factor, const std::vector<bool>& in_group, LinearSystem* system);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_VARIANCE_COMPONENT_H_
