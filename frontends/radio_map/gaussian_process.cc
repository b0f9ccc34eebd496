#include "frontends/radio_map/gaussian_process.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "frontends/radio_map/explained_variance.h"

namespace walkgraph {
namespace {

double Square(double value) { return value * value; }

// Constant plus Matern-3/2 covariance over the squared distance, tabulated: a field needs it some
// 100,000 times. Linear in the distance between entries 1/64 of the length scale apart (error under
// 1e-4 of the amplitude squared).
class Kernel {
 public:
  explicit Kernel(const FieldPrior& prior)
      : entries_per_m_(64.0 / prior.length_m), constant_(Square(prior.constant_sigma_db)) {
    for (int i = 0; i <= kEntries; ++i) {
      const double r = std::numbers::sqrt3 * i / 64.0;
      table_.push_back(Square(prior.amplitude_db) * (1.0 + r) * std::exp(-r));
    }
  }
  // Covariances (dB^2) in place of distances (m).
  void Apply(Eigen::Ref<Eigen::ArrayXd> distances_m) const {
    for (double& distance_m : distances_m) {
      const double at = std::min(distance_m * entries_per_m_, kEntries - 1.0);
      const int i = static_cast<int>(at);
      const double t = at - i;
      const auto k = static_cast<std::size_t>(i);
      distance_m = constant_ + (1.0 - t) * table_[k] + t * table_[k + 1];
    }
  }

 private:
  static constexpr int kEntries = 64 * 12;  // beyond 12 length scales nothing is left
  double entries_per_m_;
  double constant_;
  std::vector<double> table_;
};

}  // namespace

FieldProcess::FieldProcess(const std::vector<FieldSample>& samples, const FieldPrior& prior)
    : prior_(prior) {
  const Eigen::Index n = static_cast<Eigen::Index>(samples.size());
  positions_m_.resize(2, n);
  Eigen::VectorXd deviation(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const FieldSample& sample = samples[static_cast<std::size_t>(i)];
    positions_m_.col(i) = sample.position_m;
    deviation(i) = sample.rssi_dbm - prior_.constant_mean_dbm;
    trial_.push_back(sample.trial);
  }
  Eigen::MatrixXd covariance = Covariance(positions_m_);
  covariance.diagonal().array() += Square(prior_.noise_db);
  const Eigen::LLT<Eigen::MatrixXd> cholesky(covariance);
  lower_ = cholesky.matrixL();
  alpha_ = cholesky.solve(deviation);

  const double constant = Square(prior_.constant_sigma_db);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(n);
  far_mean_dbm_ = prior_.constant_mean_dbm + constant * alpha_.sum();
  const double explained =
      constant * constant * lower_.triangularView<Eigen::Lower>().solve(ones).squaredNorm();
  far_sigma_db_ =
      std::sqrt(constant - explained + Square(prior_.amplitude_db) + Square(prior_.noise_db));
}

Eigen::MatrixXd FieldProcess::Covariance(const Eigen::Matrix2Xd& positions_m) const {
  const Kernel kernel(prior_);
  Eigen::MatrixXd covariance(positions_m_.cols(), positions_m.cols());
  const Eigen::ArrayXd x_m = positions_m_.row(0), y_m = positions_m_.row(1);
  for (Eigen::Index j = 0; j < positions_m.cols(); ++j) {
    auto column = covariance.col(j).array();
    column = ((x_m - positions_m(0, j)).square() + (y_m - positions_m(1, j)).square()).sqrt();
    kernel.Apply(column);
  }
  return covariance;
}

void FieldProcess::Predict(const Eigen::Matrix2Xd& positions_m, Eigen::VectorXd* mean_dbm,
                           Eigen::VectorXd* sigma_db) const {
  const Eigen::MatrixXd cross = Covariance(positions_m);
  *mean_dbm = (cross.transpose() * alpha_).array() + prior_.constant_mean_dbm;
  // The variance is a difference of similar numbers only where it is small against the noise, so
  // single precision does.
  const Eigen::ArrayXf explained = ExplainedVariance(lower_.cast<float>(), cross.cast<float>());
  const double total = Square(prior_.constant_sigma_db) + Square(prior_.amplitude_db);
  const double noise = Square(prior_.noise_db);
  *sigma_db = ((total - explained.cast<double>()).max(0.0) + noise).sqrt();
}

Eigen::VectorXd FieldProcess::LeaveOneTrialOut(const std::vector<FieldSample>& readings) const {
  using Indices = std::vector<Eigen::Index>;
  std::map<std::uint32_t, Indices> samples_of, readings_of;
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    samples_of[trial_[i]].push_back(static_cast<Eigen::Index>(i));
  }
  Eigen::Matrix2Xd positions_m(2, std::ssize(readings));
  Eigen::VectorXd residual(positions_m.cols());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    positions_m.col(at) = readings[i].position_m;
    residual(at) = readings[i].rssi_dbm - prior_.constant_mean_dbm;
    readings_of[readings[i].trial].push_back(at);
  }
  const Eigen::Index n = positions_m_.cols();
  Eigen::MatrixXd precision = Eigen::MatrixXd::Identity(n, n);
  lower_.triangularView<Eigen::Lower>().solveInPlace(precision);
  precision = (precision.transpose() * precision).eval();
  const Eigen::MatrixXd cross = Covariance(positions_m);
  const Eigen::MatrixXd weights = precision * cross;

  // What all samples say, less what those of the reading's own trial do.
  residual -= cross.transpose() * alpha_;
  Eigen::VectorXd explained = (cross.array() * weights.array()).colwise().sum().transpose();
  for (const auto& [trial, of_trial] : readings_of) {
    const Indices& out = samples_of[trial];
    if (out.empty()) continue;
    const Eigen::MatrixXd own = weights(out, of_trial);
    const Eigen::MatrixXd solved = Eigen::MatrixXd(precision(out, out)).llt().solve(own);
    residual(of_trial) += solved.transpose() * alpha_(out);
    explained(of_trial) -= (own.array() * solved.array()).colwise().sum().matrix().transpose();
  }
  const double total = Square(prior_.constant_sigma_db) + Square(prior_.amplitude_db);
  const Eigen::ArrayXd variance = (total - explained.array()).max(0.0) + Square(prior_.noise_db);
  return residual.array() / variance.sqrt();
}

}  // namespace walkgraph
