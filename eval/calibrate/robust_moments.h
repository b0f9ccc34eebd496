#ifndef WALKGRAPH_EVAL_CALIBRATE_ROBUST_MOMENTS_H_
#define WALKGRAPH_EVAL_CALIBRATE_ROBUST_MOMENTS_H_

#include <cstddef>
#include <vector>

namespace walkgraph {

struct Moments {
  double mean = 0;
  double variance = 0;      // about the mean, with n - 1
  std::size_t samples = 0;  // after clipping
};

// Mean and variance of what lies within three robust standard deviations (1.4826 median absolute
// deviations) of the median. Fewer than two samples give a variance of zero.
Moments ClippedMoments(const std::vector<double>& values);

struct Line {
  double intercept = 0;
  double slope = 0;
};

// Variance of zero-mean `differences` as a line over `lag_s`, by least squares on their squares
// after the clipping above. Both coefficients are at least zero: a fit that would leave the
// quadrant is repeated with the offending one at zero.
Line VarianceOverLag(const std::vector<double>& differences, const std::vector<double>& lag_s);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_CALIBRATE_ROBUST_MOMENTS_H_
