#ifndef WALKGRAPH_SOLVERS_BASELINES_TCPF_STEP_ERROR_H_
#define WALKGRAPH_SOLVERS_BASELINES_TCPF_STEP_ERROR_H_

namespace walkgraph {

// Error of a walking direction as the paper fits it: normal, radians.
struct HeadingError {
  double mean_rad = 0;
  double sigma_rad = 0;
};

// Probability of an error within +- limit_rad. The measured errors have heavier tails (94.00 %
// within 20 degrees where the normal fitted to them gives 97.82).
double ProbabilityWithin(double limit_rad, const HeadingError& error);

// Expected distance between where a step of `length_m` leads and where it is taken to lead: E of
// 2 L |sin(t / 2)| over the error t. Source: equation (14) of the TCPF paper, which integrates it
// over the density; here by Simpson's rule over +- 8 sigma. Precondition: sigma_rad > 0.
double ExpectedStepError(double length_m, const HeadingError& error);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_TCPF_STEP_ERROR_H_
