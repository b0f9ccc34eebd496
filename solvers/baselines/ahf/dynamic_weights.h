#ifndef WALKGRAPH_SOLVERS_BASELINES_AHF_DYNAMIC_WEIGHTS_H_
#define WALKGRAPH_SOLVERS_BASELINES_AHF_DYNAMIC_WEIGHTS_H_

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <span>

namespace walkgraph {

// Estimated error of a fix, m: the mean distance of the best fingerprint's position from those of
// the next best, not below half the spacing of the fingerprints. `candidates_m`: positions, best
// first. Source: Lemelson et al., LoCA 2009, "best candidates set".
inline double BestCandidateSetError(std::span<const Eigen::Vector2d> candidates_m,
                                    double spacing_m) {
  double sum_m = 0;
  for (const Eigen::Vector2d& candidate : candidates_m)
    sum_m += (candidate - candidates_m[0]).norm();
  const double others = std::max(1.0, static_cast<double>(candidates_m.size()) - 1);
  return std::max(sum_m / others, spacing_m / 2);
}

// Weights of prediction and measurement from the estimated errors of the fixes so far. The paper
// prints sums for what can only be products; these are w_m = (1/err_k) / N and w_p = (1/mean of the
// errors before) / N with N so that they add up to one. The first fix has all the weight.
class DynamicWeights {
 public:
  // The weight of the next fix, whose estimated error (> 0) is given; the prediction's is the rest.
  double NextMeasurementWeight(double error_m) {
    const double weight = count_ == 0 ? 1.0 : MeanError() / (MeanError() + error_m);
    sum_m_ += error_m;
    ++count_;
    return weight;
  }
  // Mean of the estimated errors so far, m. Precondition: there was one.
  double MeanError() const { return sum_m_ / count_; }

 private:
  double sum_m_ = 0;
  int count_ = 0;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_AHF_DYNAMIC_WEIGHTS_H_
