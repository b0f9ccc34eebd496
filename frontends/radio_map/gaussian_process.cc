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

// exp(r) to a relative 2e-6 where r < 5, from where on e^-r hardly counts: sixteen factors, each a
// polynomial. A field needs it some 100,000 times, and of plain products compilers make vectors.
inline float SinglePrecisionExp(float r) {
  const float x = r / 16;
  const float root = 1 + x * (1 + x * (1.F / 2 + x * (1.F / 6 + x * (1.F / 24 + x / 120))));
  const float fourth = root * root * root * root;
  return fourth * fourth * fourth * fourth;
}

// Constant plus Matern-3/2 covariances (dB^2) in place of distances (m).
void ApplyKernel(const FieldPrior& prior, Eigen::Ref<Eigen::ArrayXf> distances_m) {
  const auto scale = static_cast<float>(std::numbers::sqrt3 / prior.length_m);
  const auto amplitude = static_cast<float>(Square(prior.amplitude_db));
  const auto constant = static_cast<float>(Square(prior.constant_sigma_db));
  for (float& value : distances_m) {
    const float r = scale * value;
    value = constant + amplitude * (1 + r) / SinglePrecisionExp(r);
  }
}

void ApplyKernel(const FieldPrior& prior, Eigen::Ref<Eigen::ArrayXd> distances_m) {
  distances_m *= std::numbers::sqrt3 / prior.length_m;
  distances_m = Square(prior.constant_sigma_db) +
                Square(prior.amplitude_db) * (1 + distances_m) * (-distances_m).exp();
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
    trial_.push_back(sample.trial);
  }
  Eigen::MatrixXd covariance = Covariance<double>(positions_m_);
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

template <typename Scalar>
Eigen::MatrixX<Scalar> FieldProcess::Covariance(const Eigen::Matrix2Xd& positions_m) const {
  Eigen::MatrixX<Scalar> covariance(positions_m_.cols(), positions_m.cols());
  // From the first sample, so that a site far from its origin loses no digits.
  const Eigen::Vector2d origin_m = positions_m_.col(0);
  const Eigen::ArrayX<Scalar> x_m = (positions_m_.row(0).array() - origin_m.x()).cast<Scalar>();
  const Eigen::ArrayX<Scalar> y_m = (positions_m_.row(1).array() - origin_m.y()).cast<Scalar>();
  for (Eigen::Index j = 0; j < positions_m.cols(); ++j) {
    const Eigen::Vector2<Scalar> at = (positions_m.col(j) - origin_m).cast<Scalar>();
    auto column = covariance.col(j).array();
    column = ((x_m - at.x()).square() + (y_m - at.y()).square()).sqrt();
    ApplyKernel(prior_, column);
  }
  return covariance;
}

void FieldProcess::Predict(const Eigen::Matrix2Xd& positions_m, Eigen::VectorXd* mean_dbm,
                           Eigen::VectorXd* sigma_db) const {
  const Eigen::MatrixXf cross = Covariance<float>(positions_m);
  mean_dbm->resize(cross.cols());
  for (Eigen::Index j = 0; j < cross.cols(); ++j) {
    (*mean_dbm)(j) = prior_.constant_mean_dbm + cross.col(j).cast<double>().dot(alpha_);
  }
  // The variance is a difference of similar numbers only where it is small against the noise, so
  // single precision does.
  const Eigen::ArrayXf explained = ExplainedVariance(lower_.cast<float>(), cross);
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
  const Eigen::MatrixXd cross = Covariance<double>(positions_m);
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
