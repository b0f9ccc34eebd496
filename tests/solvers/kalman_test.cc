#include "solvers/baselines/kalman.h"

#include <gtest/gtest.h>

namespace walkgraph {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Row2 = Eigen::Matrix<double, 1, 2>;
using Scalar = Eigen::Matrix<double, 1, 1>;

const Row2 kObservesFirst(1, 0);

// One number of white acceleration noise over a second, seen directly.
Matrix2d WhiteAcceleration() {
  const Vector2d b(0.5, 1);
  return b * b.transpose();
}

TEST(Kalman, ConstantVelocityReachesTheKnownSteadyGain) {
  const Matrix2d a = (Matrix2d() << 1, 1, 0, 1).finished();
  KalmanState<2> state{Vector2d::Zero(), 100 * Matrix2d::Identity()};
  for (int k = 0; k < 200; ++k) {
    state = KalmanPredict<2>(state, a, Vector2d::Zero(), WhiteAcceleration());
    if (k == 199) {
      // dt = 1, sigma = 1, R = 1: K = (0.75, 0.5).
      const Vector2d gain = KalmanGain<2, 1>(state, kObservesFirst, Scalar(1));
      EXPECT_NEAR(gain(0), 0.75, 1e-9);
      EXPECT_NEAR(gain(1), 0.5, 1e-9);
    }
    state = KalmanUpdate<2, 1>(state, Scalar(0), kObservesFirst, Scalar(1));
  }
  EXPECT_NEAR(state.covariance(0, 0), 0.75, 1e-9);
}

// With a flat prior and no process noise the filter is the line of least squares.
TEST(Kalman, EqualsLeastSquaresWithoutProcessNoise) {
  const double observed[] = {1.0, 2.5, 2.7, 4.4, 5.1};
  const Matrix2d a = (Matrix2d() << 1, 1, 0, 1).finished();
  KalmanState<2> state{Vector2d::Zero(), 1e9 * Matrix2d::Identity()};
  for (int k = 0; k < 5; ++k) {
    if (k > 0) state = KalmanPredict<2>(state, a, Vector2d::Zero(), Matrix2d::Zero());
    const Scalar innovation(observed[k] - state.mean(0));
    state = KalmanUpdate<2, 1>(state, innovation, kObservesFirst, Scalar(0.25));
  }
  // Slope sum (k - 2) z / 10 = 1.01 and mean 3.14: at k = 4 the line is at 3.14 + 2.02.
  EXPECT_NEAR(state.mean(0), 5.16, 1e-5);
  EXPECT_NEAR(state.mean(1), 1.01, 1e-5);
  EXPECT_NEAR(state.covariance(1, 1), 0.25 / 10, 1e-6);
  EXPECT_NEAR(state.covariance(0, 0), 0.25 * (1.0 / 5 + 4.0 / 10), 1e-6);
}

// Two observations at once say what they say one after the other; sizes may be dynamic.
TEST(Kalman, StackedObservationsEqualSuccessiveOnes) {
  const Matrix2d prior = (Matrix2d() << 4, 1, 1, 3).finished();
  const KalmanState<2> state{Vector2d(1, -2), prior};
  KalmanState<2> successive = KalmanUpdate<2, 1>(state, Scalar(3 - 1), kObservesFirst, Scalar(2));
  successive =
      KalmanUpdate<2, 1>(successive, Scalar(5 - successive.mean(0)), kObservesFirst, Scalar(0.5));

  const KalmanState<Eigen::Dynamic> dynamic{state.mean, state.covariance};
  const Eigen::MatrixXd c = (Matrix2d() << 1, 0, 1, 0).finished();
  const Eigen::MatrixXd noise = Vector2d(2, 0.5).asDiagonal();
  const Eigen::VectorXd innovation = Vector2d(3 - 1, 5 - 1);
  const KalmanState<Eigen::Dynamic> stacked =
      KalmanUpdate<Eigen::Dynamic, Eigen::Dynamic>(dynamic, innovation, c, noise);
  EXPECT_TRUE(stacked.mean.isApprox(successive.mean, 1e-12));
  EXPECT_TRUE(stacked.covariance.isApprox(successive.covariance, 1e-12));
}

TEST(Kalman, AnInputShiftsTheMeanAlone) {
  const KalmanState<2> state{Vector2d(1, 2), Matrix2d::Identity()};
  const KalmanState<2> moved =
      KalmanPredict<2>(state, Matrix2d::Identity(), Vector2d(0.05, 0.1), Matrix2d::Zero());
  EXPECT_TRUE(moved.mean.isApprox(Vector2d(1.05, 2.1), 1e-15));
  EXPECT_EQ(moved.covariance, state.covariance);
}

}  // namespace
}  // namespace walkgraph
