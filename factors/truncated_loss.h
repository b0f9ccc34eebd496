#ifndef WALKGRAPH_FACTORS_TRUNCATED_LOSS_H_
#define WALKGRAPH_FACTORS_TRUNCATED_LOSS_H_

#include <ceres/loss_function.h>

#include <cmath>

namespace walkgraph {

// The squared norm that a whitened residual of one or two rows exceeds as rarely as a single row
// exceeds `sigmas`: the chi-square quantile of the same probability.
inline double ChiSquareThreshold(double sigmas, int rows) {
  // In two dimensions P(s > t) = exp(-t / 2).
  return rows == 1 ? sigmas * sigmas : -2.0 * std::log(std::erfc(sigmas / std::sqrt(2.0)));
}

// Truncated least squares: the parabola up to the threshold, constant beyond, so that an outlier of
// any size has no say. Not convex; graduated non-convexity reaches it through a family of losses
// with a control mu, which is the parabola at first and the truncated one in the end (Yang,
// Antonante, Tzoumas and Carlone, Graduated Non-Convexity for Robust Spatial Perception, RA-L
// 2020). With c^2 the threshold and s the squared norm:
//   s                                        s <= c^2 mu / (mu + 1)
//   2 c sqrt(s mu (mu + 1)) - mu (c^2 + s)   between
//   c^2                                      s >= c^2 (mu + 1) / mu
// A ten-thousandth of the parabola stays everywhere: a cut factor that alone ties a state must not
// leave it free.
class TruncatedLoss : public ceres::LossFunction {
 public:
  static constexpr double kFinalMu = 1e3;  // all but truncated

  explicit TruncatedLoss(double threshold) : threshold_(threshold) {}

  double threshold() const { return threshold_; }
  void SetParabola() { parabola_ = true; }
  void SetMu(double mu) {
    parabola_ = false;
    mu_ = mu;
  }

  void Evaluate(double s, double rho[3]) const override {
    rho[0] = s;
    rho[1] = 1;
    rho[2] = 0;
    if (parabola_ || s <= threshold_ * mu_ / (mu_ + 1)) return;
    double value = threshold_, slope = 0, curvature = 0;
    if (s < threshold_ * (mu_ + 1) / mu_) {
      const double root = std::sqrt(threshold_ * mu_ * (mu_ + 1));
      value = 2 * root * std::sqrt(s) - mu_ * (threshold_ + s);
      slope = root / std::sqrt(s) - mu_;
      curvature = -0.5 * root / (s * std::sqrt(s));
    }
    rho[0] = (1 - kKept) * value + kKept * s;
    rho[1] = (1 - kKept) * slope + kKept;
    rho[2] = (1 - kKept) * curvature;
  }

 private:
  static constexpr double kKept = 1e-4;

  double threshold_;
  double mu_ = kFinalMu;
  bool parabola_ = false;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_TRUNCATED_LOSS_H_
