#ifndef WALKGRAPH_SOLVERS_BASELINES_KALMAN_H_
#define WALKGRAPH_SOLVERS_BASELINES_KALMAN_H_

#include <Eigen/Core>
#include <Eigen/LU>

namespace walkgraph {

// A Gaussian belief about a state of N numbers (or Eigen::Dynamic), in the units of its model.
template <int N>
struct KalmanState {
  Eigen::Matrix<double, N, 1> mean;
  Eigen::Matrix<double, N, N> covariance;
};

// The belief after x' = A x + shift + w, w ~ N(0, noise). A known input u with matrix B is the
// shift B u. Source: Kalman, ASME J. Basic Engineering 82 (1960).
template <int N>
KalmanState<N> KalmanPredict(const KalmanState<N>& state, const Eigen::Matrix<double, N, N>& a,
                             const Eigen::Matrix<double, N, 1>& shift,
                             const Eigen::Matrix<double, N, N>& noise) {
  return {a * state.mean + shift, a * state.covariance * a.transpose() + noise};
}

// K = P C^T (C P C^T + R)^-1, N x M, for an observation z = C x + v of M numbers, v ~ N(0, R).
// Precondition: C P C^T + R is invertible.
template <int N, int M>
Eigen::Matrix<double, N, M> KalmanGain(const KalmanState<N>& state,
                                       const Eigen::Matrix<double, M, N>& c,
                                       const Eigen::Matrix<double, M, M>& noise) {
  const Eigen::Matrix<double, M, M> innovation = c * state.covariance * c.transpose() + noise;
  return state.covariance * c.transpose() * innovation.inverse();
}

// The belief after an observation whose innovation z - C x the caller has formed (and wrapped,
// where it is an angle). Joseph's form of the covariance: symmetric and positive for any gain, so
// that rounding cannot spoil a long walk. Source: Bucy and Joseph, Filtering for Stochastic
// Processes with Applications to Guidance (1968).
template <int N, int M>
KalmanState<N> KalmanUpdate(const KalmanState<N>& state,
                            const Eigen::Matrix<double, M, 1>& innovation,
                            const Eigen::Matrix<double, M, N>& c,
                            const Eigen::Matrix<double, M, M>& noise) {
  const Eigen::Matrix<double, N, M> gain = KalmanGain<N, M>(state, c, noise);
  const Eigen::Index n = state.mean.size();
  const Eigen::Matrix<double, N, N> kept = Eigen::Matrix<double, N, N>::Identity(n, n) - gain * c;
  return {state.mean + gain * innovation,
          kept * state.covariance * kept.transpose() + gain * noise * gain.transpose()};
}

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_KALMAN_H_
