#include "frontends/radio_map/gaussian_process.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "frontends/radio_map/explained_variance.h"

namespace walkgraph {
namespace {

// Constant plus Matern-3/2 covariance over the squared distance, tabulated: a field needs it some
// 100,000 times. Linear in the distance between entries 1/64 of the length scale apart (error under
// 1e-4 of the amplitude squared).
class Kernel {
 public:
  explicit Kernel(const FieldPrior& prior)
      : entries_per_m_(64.0 / prior.length_m),
        constant_(prior.constant_sigma_db * prior.constant_sigma_db) {
    for (int i = 0; i <= kEntries; ++i) {
      const double r = std::numbers::sqrt3 * i / 64.0;
      table_.push_back(prior.amplitude_db * prior.amplitude_db * (1.0 + r) * std::exp(-r));
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
  covariance.diagonal().array() += prior_.noise_db * prior_.noise_db;
  const Eigen::LLT<Eigen::MatrixXd> cholesky(covariance);
  lower_ = cholesky.matrixL();
  alpha_ = cholesky.solve(deviation);

  const double constant = prior_.constant_sigma_db * prior_.constant_sigma_db;
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(n);
  far_mean_dbm_ = prior_.constant_mean_dbm + constant * alpha_.sum();
  const double explained =
      constant * constant * lower_.triangularView<Eigen::Lower>().solve(ones).squaredNorm();
  far_sigma_db_ = std::sqrt(constant - explained + prior_.amplitude_db * prior_.amplitude_db +
                            prior_.noise_db * prior_.noise_db);
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
  const double total = prior_.constant_sigma_db * prior_.constant_sigma_db +
                       prior_.amplitude_db * prior_.amplitude_db;
  const double noise = prior_.noise_db * prior_.noise_db;
  *sigma_db = ((total - explained.cast<double>()).max(0.0) + noise).sqrt();
}

FieldProcess::LeftOut FieldProcess::LeaveOneTrialOut() const {
  const Eigen::Index n = positions_m_.cols();
  Eigen::MatrixXd precision = Eigen::MatrixXd::Identity(n, n);
  lower_.triangularView<Eigen::Lower>().solveInPlace(precision);
  precision = (precision.transpose() * precision).eval();

  std::map<std::uint32_t, std::vector<Eigen::Index>> by_trial;
  for (Eigen::Index i = 0; i < n; ++i) by_trial[trial_[static_cast<std::size_t>(i)]].push_back(i);

  LeftOut out;
  out.whitened.resize(static_cast<std::size_t>(n));
  out.sigma_db.resize(static_cast<std::size_t>(n));
  for (const auto& [trial, members] : by_trial) {
    const Eigen::MatrixXd block = precision(members, members);
    const Eigen::MatrixXd covariance =
        block.llt().solve(Eigen::MatrixXd::Identity(block.rows(), block.cols()));
    const Eigen::VectorXd residual = covariance * alpha_(members);
    for (std::size_t k = 0; k < members.size(); ++k) {
      const Eigen::Index i = static_cast<Eigen::Index>(k);
      const double sigma = std::sqrt(covariance(i, i));
      const double z = residual(i) / sigma;
      out.whitened[static_cast<std::size_t>(members[k])] = z;
      out.sigma_db[static_cast<std::size_t>(members[k])] = sigma;
      out.log_density -= 0.5 * z * z + std::log(sigma * std::sqrt(2.0 * std::numbers::pi));
    }
  }
  return out;
}

}  // namespace walkgraph
