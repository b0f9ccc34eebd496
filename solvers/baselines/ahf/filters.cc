#include "solvers/baselines/ahf/filters.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "solvers/baselines/ahf/dynamic_weights.h"
#include "solvers/baselines/kalman.h"

namespace walkgraph {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

// Of the places `distance_m` down the ways, that nearest to the fix: the paper's prediction.
WayCandidate PredictOnWays(const WayGraph& ways, const Vector2d& from_m, double distance_m,
                           const Vector2d& fix_m) {
  const std::vector<WayCandidate> candidates = ways.Reach(ways.Project(from_m), distance_m);
  return *std::min_element(candidates.begin(), candidates.end(),
                           [&](const WayCandidate& a, const WayCandidate& b) {
                             return (ways.PositionOf(a.at) - fix_m).squaredNorm() <
                                    (ways.PositionOf(b.at) - fix_m).squaredNorm();
                           });
}

// Prediction and fix weighed by the estimated errors; the velocity is that of the last two results.
class DynamicFilter : public PositionFilter {
 public:
  // Straight on where there are no ways.
  DynamicFilter(const WayGraph* ways, const AhfSettings& settings)
      : ways_(ways), settings_(settings), speed_mps_(settings.start_speed_mps) {}

  PositionFix Advance(const RatedFix& rated, double seconds) override {
    PositionFix result = rated.fix;
    const double weight = weights_.NextMeasurementWeight(rated.error_m);
    if (started_) {
      const Vector2d predicted_m = Predict(rated.fix.position_m, seconds);
      result.position_m = predicted_m + weight * (rated.fix.position_m - predicted_m);
      if (seconds > 0) SetVelocity((result.position_m - position_m_) / seconds);
    }
    started_ = true;
    position_m_ = result.position_m;
    return result;
  }

 private:
  Vector2d Predict(const Vector2d& fix_m, double seconds) const {
    if (ways_ == nullptr) return position_m_ + seconds * velocity_mps_;
    const WayCandidate candidate = PredictOnWays(*ways_, position_m_, seconds * speed_mps_, fix_m);
    return ways_->PositionOf(candidate.at);
  }

  void SetVelocity(const Vector2d& velocity_mps) {
    speed_mps_ = velocity_mps.norm();
    velocity_mps_ = velocity_mps;
    if (speed_mps_ <= settings_.max_speed_mps) return;
    velocity_mps_ *= settings_.max_speed_mps / speed_mps_;
    speed_mps_ = settings_.max_speed_mps;
  }

  const WayGraph* ways_;
  AhfSettings settings_;
  DynamicWeights weights_;
  bool started_ = false;
  Vector2d position_m_ = Vector2d::Zero();
  Vector2d velocity_mps_ = Vector2d::Zero();
  double speed_mps_;
};

// The basic Kalman filter: position and velocity (x, y, vx, vy), fixes of one constant spread.
class StraightKalmanFilter : public PositionFilter {
 public:
  explicit StraightKalmanFilter(const AhfSettings& settings) : settings_(settings) {}

  PositionFix Advance(const RatedFix& rated, double seconds) override {
    const double variance_m2 = settings_.fix_sigma_m * settings_.fix_sigma_m;
    if (!started_) {
      const double speed_variance = settings_.start_speed_mps * settings_.start_speed_mps;
      state_.mean << rated.fix.position_m, 0, 0;
      state_.covariance =
          Eigen::Vector4d(variance_m2, variance_m2, speed_variance, speed_variance).asDiagonal();
      started_ = true;
    } else {
      Predict(seconds);
      state_ = KalmanUpdate<4, 2>(state_, rated.fix.position_m - state_.mean.head<2>(),
                                  Eigen::Matrix<double, 2, 4>::Identity(),
                                  variance_m2 * Matrix2d::Identity());
    }
    PositionFix result = rated.fix;
    result.position_m = state_.mean.head<2>();
    result.covariance_m2 = state_.covariance.topLeftCorner<2, 2>();
    return result;
  }

 private:
  void Predict(double seconds) {
    Eigen::Matrix4d a = Eigen::Matrix4d::Identity();
    a.topRightCorner<2, 2>() = seconds * Matrix2d::Identity();
    Eigen::Matrix<double, 4, 2> b;  // what an acceleration does
    b << seconds * seconds / 2 * Matrix2d::Identity(), seconds * Matrix2d::Identity();
    b *= settings_.acceleration_sigma_mps2;
    state_ = KalmanPredict<4>(state_, a, Eigen::Vector4d::Zero(), b * b.transpose());
  }

  AhfSettings settings_;
  KalmanState<4> state_;
  bool started_ = false;
};

// The paper's state model with the Kalman gain: position and speed (x, y, s), the prediction being
// that of the way network.
class WayKalmanFilter : public PositionFilter {
 public:
  WayKalmanFilter(const WayGraph* ways, const AhfSettings& settings)
      : ways_(*ways), settings_(settings) {}

  PositionFix Advance(const RatedFix& rated, double seconds) override {
    const double variance_m2 = settings_.fix_sigma_m * settings_.fix_sigma_m;
    if (!started_) {
      const double speed = settings_.start_speed_mps;
      state_.mean << rated.fix.position_m, speed;
      state_.covariance = Eigen::Vector3d(variance_m2, variance_m2, speed * speed).asDiagonal();
      started_ = true;
    } else {
      Predict(rated.fix.position_m, seconds);
      state_ = KalmanUpdate<3, 2>(state_, rated.fix.position_m - state_.mean.head<2>(),
                                  Eigen::Matrix<double, 2, 3>::Identity(),
                                  variance_m2 * Matrix2d::Identity());
      state_.mean.z() = std::clamp(state_.mean.z(), 0.0, settings_.max_speed_mps);
    }
    PositionFix result = rated.fix;
    result.position_m = state_.mean.head<2>();
    result.covariance_m2 = state_.covariance.topLeftCorner<2, 2>();
    return result;
  }

 private:
  void Predict(const Vector2d& fix_m, double seconds) {
    const WayCandidate candidate =
        PredictOnWays(ways_, state_.mean.head<2>(), seconds * state_.mean.z(), fix_m);
    Eigen::Matrix3d a = Eigen::Matrix3d::Identity();
    a.topRightCorner<2, 1>() = seconds * candidate.direction;
    const double sigma = settings_.acceleration_sigma_mps2;
    const Eigen::Vector3d noise(seconds * seconds / 2 * sigma, seconds * seconds / 2 * sigma,
                                seconds * sigma);
    state_ = KalmanPredict<3>(state_, a, Eigen::Vector3d::Zero(),
                              noise.cwiseProduct(noise).asDiagonal());
    // Around the corners that a straight line does not know.
    state_.mean.head<2>() = ways_.PositionOf(candidate.at);
  }

  const WayGraph& ways_;
  AhfSettings settings_;
  KalmanState<3> state_;
  bool started_ = false;
};

class ParticlePositionFilter : public PositionFilter {
 public:
  ParticlePositionFilter(int particles, AhfWeights weights, const AhfSettings& settings)
      : particles_(particles), dynamic_(weights == AhfWeights::kDynamic), settings_(settings) {}

  PositionFix Advance(const RatedFix& rated, double seconds) override {
    double sigma_m = settings_.fix_sigma_m;
    if (dynamic_) {
      weights_.NextMeasurementWeight(rated.error_m);
      sigma_m *= rated.error_m / weights_.MeanError();
    }
    if (!filter_) {
      const FreeMotion motion{settings_.acceleration_sigma_mps2, settings_.start_speed_mps,
                              settings_.max_speed_mps};
      filter_.emplace(particles_, motion, static_cast<std::uint64_t>(settings_.seed),
                      rated.fix.position_m, sigma_m);
    } else {
      filter_->Predict(seconds);
      filter_->Update(rated.fix.position_m, sigma_m);
    }
    const ParticleFilter::Moments moments = filter_->Estimate();
    PositionFix result = rated.fix;
    result.position_m = moments.mean_m;
    result.covariance_m2 = moments.covariance_m2;
    return result;
  }

 private:
  int particles_;
  bool dynamic_;
  AhfSettings settings_;
  DynamicWeights weights_;
  std::optional<ParticleFilter> filter_;
};

}  // namespace

std::unique_ptr<PositionFilter> MakeAhfFilter(AhfPrediction prediction, AhfWeights weights,
                                              const WayGraph* ways, const AhfSettings& settings) {
  const bool on_ways = prediction == AhfPrediction::kWays;
  if (weights == AhfWeights::kDynamic) {
    return std::make_unique<DynamicFilter>(on_ways ? ways : nullptr, settings);
  }
  if (on_ways) return std::make_unique<WayKalmanFilter>(ways, settings);
  return std::make_unique<StraightKalmanFilter>(settings);
}

std::unique_ptr<PositionFilter> MakeParticleFilter(int particles, AhfWeights weights,
                                                   const AhfSettings& settings) {
  return std::make_unique<ParticlePositionFilter>(particles, weights, settings);
}

}  // namespace walkgraph
