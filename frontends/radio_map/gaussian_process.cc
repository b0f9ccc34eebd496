#include "frontends/radio_map/gaussian_process.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace walkgraph {
namespace {

double Matern32(double distance_m, const FieldPrior& prior) {
  const double r = std::numbers::sqrt3 * distance_m / prior.length_m;
  return prior.amplitude_db * prior.amplitude_db * (1.0 + r) * std::exp(-r);
}

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
    walk_.push_back(sample.walk);
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
  const double constant = prior_.constant_sigma_db * prior_.constant_sigma_db;
  Eigen::MatrixXd covariance(positions_m_.cols(), positions_m.cols());
  for (Eigen::Index j = 0; j < positions_m.cols(); ++j) {
    for (Eigen::Index i = 0; i < positions_m_.cols(); ++i) {
      const double distance = (positions_m_.col(i) - positions_m.col(j)).norm();
      covariance(i, j) = constant + Matern32(distance, prior_);
    }
  }
  return covariance;
}

void FieldProcess::Predict(const Eigen::Matrix2Xd& positions_m, Eigen::VectorXd* mean_dbm,
                           Eigen::VectorXd* sigma_db) const {
  Eigen::MatrixXd cross = Covariance(positions_m);
  *mean_dbm = (cross.transpose() * alpha_).array() + prior_.constant_mean_dbm;
  lower_.triangularView<Eigen::Lower>().solveInPlace(cross);
  const double total = prior_.constant_sigma_db * prior_.constant_sigma_db +
                       prior_.amplitude_db * prior_.amplitude_db;
  const double noise = prior_.noise_db * prior_.noise_db;
  *sigma_db = ((total - cross.colwise().squaredNorm().array()).max(0.0) + noise).sqrt().transpose();
}

FieldProcess::LeftOut FieldProcess::LeaveOneWalkOut() const {
  const Eigen::Index n = positions_m_.cols();
  Eigen::MatrixXd precision = Eigen::MatrixXd::Identity(n, n);
  lower_.triangularView<Eigen::Lower>().solveInPlace(precision);
  precision = (precision.transpose() * precision).eval();

  std::map<std::uint32_t, std::vector<Eigen::Index>> by_walk;
  for (Eigen::Index i = 0; i < n; ++i) by_walk[walk_[static_cast<std::size_t>(i)]].push_back(i);

  LeftOut out;
  out.whitened.resize(static_cast<std::size_t>(n));
  for (const auto& [walk, members] : by_walk) {
    const Eigen::MatrixXd block = precision(members, members);
    const Eigen::MatrixXd covariance =
        block.llt().solve(Eigen::MatrixXd::Identity(block.rows(), block.cols()));
    const Eigen::VectorXd residual = covariance * alpha_(members);
    for (std::size_t k = 0; k < members.size(); ++k) {
      const Eigen::Index i = static_cast<Eigen::Index>(k);
      const double sigma = std::sqrt(covariance(i, i));
      const double z = residual(i) / sigma;
      out.whitened[static_cast<std::size_t>(members[k])] = z;
      out.log_density -= 0.5 * z * z + std::log(sigma * std::sqrt(2.0 * std::numbers::pi));
    }
  }
  return out;
}

}  // namespace walkgraph
