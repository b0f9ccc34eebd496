#ifndef WALKGRAPH_SOLVERS_BASELINES_MUFAF_TRACKING_H_
#define WALKGRAPH_SOLVERS_BASELINES_MUFAF_TRACKING_H_

#include <Eigen/Core>
#include <Eigen/LU>
#include <vector>

#include "solvers/baselines/kalman.h"

namespace walkgraph {

// How a target moves (TTP, the target tracking process): state [x, y, vx, vy] in m and m/s.
struct ConstantVelocity {
  double acceleration_sigma_mps2 = 1;
  double input_mps2 = 0;  // u of equation (11), along +x and +y alike

  // Equations (7), (9), (11) and (13) of the MUFAF paper, `seconds` >= 0 on.
  KalmanState<4> Predict(const KalmanState<4>& state, double seconds) const;
};

// A fix of one radio: what the position estimation says, with its mean error as its sigma per axis.
struct RadioFix {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  double error_m = 1;
};

// The belief after the first fix: at rest somewhere there.
KalmanState<4> BeginTrack(const RadioFix& fix);

// The belief after the fixes of all radios that reported in a window, stacked: equations (17)-(19).
KalmanState<4> UpdateTrack(const KalmanState<4>& state, const std::vector<RadioFix>& fixes);

// Track-to-track fusion: the most likely state if the tracks' errors were independent, equations
// (15) and (16). They are not, for they share the target's motion: the covariance is too small
// (a scalar walk with Q = 1 under two radios with R = 4 claims 0.78 where 1.08 is true).
// Precondition: not empty, covariances invertible.
template <int N>
KalmanState<N> FuseTracks(const std::vector<KalmanState<N>>& tracks) {
  Eigen::Matrix<double, N, N> information = Eigen::Matrix<double, N, N>::Zero();
  Eigen::Matrix<double, N, 1> sum = Eigen::Matrix<double, N, 1>::Zero();
  for (const KalmanState<N>& track : tracks) {
    const Eigen::Matrix<double, N, N> inverse = track.covariance.inverse();
    information += inverse;
    sum += inverse * track.mean;
  }
  const Eigen::Matrix<double, N, N> covariance = information.inverse();
  return {covariance * sum, covariance};
}

// The last stage's smoothing of positions, equations (20)-(25), with beta = alpha^2 / (2 - alpha).
class AlphaBetaFilter {
 public:
  // Stable for 0 < alpha < 1, 0 < beta < 2 and 4 - 2 alpha - beta > 0, which alpha in (0, 1) is.
  // Throws std::invalid_argument otherwise.
  explicit AlphaBetaFilter(double alpha);

  double beta() const { return alpha_ * alpha_ / (2 - alpha_); }
  // The position after a measurement `seconds` (> 0) after the one before, which is where the first
  // one is.
  Eigen::Vector2d Advance(const Eigen::Vector2d& measured_m, double seconds);

 private:
  double alpha_;
  bool begun_ = false;
  Eigen::Vector2d position_m_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d velocity_mps_ = Eigen::Vector2d::Zero();
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_MUFAF_TRACKING_H_
