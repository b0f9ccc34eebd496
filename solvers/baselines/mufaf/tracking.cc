#include "solvers/baselines/mufaf/tracking.h"

#include <cstddef>
#include <stdexcept>

namespace walkgraph {

KalmanState<4> ConstantVelocity::Predict(const KalmanState<4>& state, double seconds) const {
  Eigen::Matrix4d a = Eigen::Matrix4d::Identity();
  a.topRightCorner<2, 2>() = seconds * Eigen::Matrix2d::Identity();
  Eigen::Matrix<double, 4, 2> b;  // acceleration per axis to state
  b << seconds * seconds / 2 * Eigen::Matrix2d::Identity(), seconds * Eigen::Matrix2d::Identity();
  const double variance = acceleration_sigma_mps2 * acceleration_sigma_mps2;
  return KalmanPredict<4>(state, a, b * Eigen::Vector2d::Constant(input_mps2),
                          variance * b * b.transpose());
}

KalmanState<4> BeginTrack(const RadioFix& fix) {
  constexpr double kWalkingMps = 1.5;
  KalmanState<4> state;
  state.mean << fix.position_m, 0, 0;
  const double position = fix.error_m * fix.error_m;
  state.covariance =
      Eigen::Vector4d(position, position, kWalkingMps * kWalkingMps, kWalkingMps * kWalkingMps)
          .asDiagonal();
  return state;
}

KalmanState<4> UpdateTrack(const KalmanState<4>& state, const std::vector<RadioFix>& fixes) {
  const auto rows = static_cast<Eigen::Index>(2 * fixes.size());
  Eigen::Matrix<double, Eigen::Dynamic, 4> c = Eigen::MatrixXd::Zero(rows, 4);
  Eigen::VectorXd innovation(rows), variance(rows);
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(2 * i);
    c.block<2, 2>(row, 0).setIdentity();
    innovation.segment<2>(row) = fixes[i].position_m - state.mean.head<2>();
    variance.segment<2>(row).setConstant(fixes[i].error_m * fixes[i].error_m);
  }
  const Eigen::MatrixXd noise = variance.asDiagonal();
  return KalmanUpdate<4, Eigen::Dynamic>(state, innovation, c, noise);
}

AlphaBetaFilter::AlphaBetaFilter(double alpha) : alpha_(alpha) {
  if (!(alpha > 0 && alpha < 1)) {
    throw std::invalid_argument("an alpha-beta filter is stable for 0 < alpha < 1");
  }
}

Eigen::Vector2d AlphaBetaFilter::Advance(const Eigen::Vector2d& measured_m, double seconds) {
  if (!begun_) {
    begun_ = true;
    position_m_ = measured_m;
    return position_m_;
  }
  const Eigen::Vector2d predicted = position_m_ + seconds * velocity_mps_;
  const Eigen::Vector2d error = measured_m - predicted;
  position_m_ = predicted + alpha_ * error;
  velocity_mps_ += beta() / seconds * error;
  return position_m_;
}

}  // namespace walkgraph
