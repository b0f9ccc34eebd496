#ifndef WALKGRAPH_EVAL_CALIBRATE_ROBUST_MOMENTS_H_
#define WALKGRAPH_EVAL_CALIBRATE_ROBUST_MOMENTS_H_

#include <cstddef>
#include <vector>

namespace walkgraph {

// The upper one of two middle values. Precondition: not empty.
double Median(std::vector<double> values);

struct Moments {
  double mean = 0;
  double variance = 0;      // about the mean, with n - 1
  std::size_t samples = 0;  // after clipping
};

// Mean and variance of what lies within three robust standard deviations (1.4826 median absolute
// deviations) of the median. Fewer than two samples give a variance of zero.
Moments ClippedMoments(const std::vector<double>& values);

// Mean and variance of what stands behind values that each have an error of their own, of known
// variance: the random-effects model of meta-analysis by maximum likelihood, after the clipping
// above. The variance is at least its own standard error: from fewer values a smaller one cannot be
// told, and as a prior a spread that is too small costs more than one that is too large. One
// `error_variance` a value.
Moments RandomEffects(const std::vector<double>& values, const std::vector<double>& error_variance);

struct Line {
  double intercept = 0;
  double slope = 0;
};

// Variance of zero-mean `differences` as a sum of `columns` (one value a difference each), by least
// squares on their squares after the clipping above. Coefficients are at least zero: of all subsets
// of columns whose fit is, the best; the first where columns cannot be told apart.
std::vector<double> VarianceComponents(const std::vector<double>& differences,
                                       const std::vector<std::vector<double>>& columns);

// The same where the variances differ much: every difference counts relative to the variance that
// the fit gives it, and is clipped at three robust deviations of the whitened ones, in ten
// rounds. Without, the clipping takes most of what has the greatest variances.
std::vector<double> RelativeVarianceComponents(const std::vector<double>& differences,
                                               const std::vector<std::vector<double>>& columns);

// The same as VarianceComponents, as a line over `lag_s`.
Line VarianceOverLag(const std::vector<double>& differences, const std::vector<double>& lag_s);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_CALIBRATE_ROBUST_MOMENTS_H_
