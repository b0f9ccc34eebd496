#include "eval/calibrate/robust_moments.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

namespace walkgraph {
namespace {

constexpr double kSmallestVariance = 1e-12;  // values without any error of their own count alike

// Half width of the interval about `center` that counts.
double ClipWidth(const std::vector<double>& values, double center) {
  std::vector<double> deviation;
  deviation.reserve(values.size());
  for (const double value : values) deviation.push_back(std::abs(value - center));
  return 3.0 * 1.4826 * Median(std::move(deviation));
}

// Least squares on the columns in `subset`, zero for the others; nothing where they are dependent.
std::optional<Eigen::VectorXd> FitSubset(const Eigen::MatrixXd& normal,
                                         const Eigen::VectorXd& right, unsigned subset) {
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index c = 0; c < right.size(); ++c) {
    if ((subset >> c & 1U) != 0) chosen.push_back(c);
  }
  const Eigen::FullPivLU<Eigen::MatrixXd> solver(normal(chosen, chosen));
  if (!solver.isInvertible()) return std::nullopt;
  Eigen::VectorXd fit = Eigen::VectorXd::Zero(right.size());
  fit(chosen) = solver.solve(right(chosen));
  return fit;
}

}  // namespace

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Moments ClippedMoments(const std::vector<double>& values) {
  Moments moments;
  if (values.empty()) return moments;
  const double center = Median(values);
  const double width = ClipWidth(values, center);
  double sum = 0, squares = 0;
  for (const double value : values) {
    if (std::abs(value - center) > width) continue;
    sum += value - center;
    squares += (value - center) * (value - center);
    ++moments.samples;
  }
  const auto n = static_cast<double>(moments.samples);
  moments.mean = center + sum / n;
  if (moments.samples > 1) moments.variance = (squares - sum * sum / n) / (n - 1.0);
  return moments;
}

Moments RandomEffects(const std::vector<double>& values,
                      const std::vector<double>& error_variance) {
  constexpr int kMaxRounds = 200;
  constexpr double kConverged = 1e-6;  // of the variance
  Moments moments = ClippedMoments(values);
  if (moments.samples < 2) return moments;
  const double center = Median(values), width = ClipWidth(values, center);
  double standard_error = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    double weights = 0, sum = 0, squared_weights = 0, excess = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::abs(values[i] - center) > width) continue;
      const double weight = 1.0 / std::max(kSmallestVariance, moments.variance + error_variance[i]);
      const double apart = values[i] - moments.mean;
      weights += weight;
      sum += weight * values[i];
      squared_weights += weight * weight;
      excess += weight * weight * (apart * apart - error_variance[i]);
    }
    const double before = moments.variance;
    moments.mean = sum / weights;
    // The fixed point is where the likelihood's derivative vanishes.
    moments.variance = std::max(0.0, excess / squared_weights);
    standard_error = std::sqrt(2.0 / squared_weights);
    if (std::abs(moments.variance - before) <= kConverged * before) break;
  }
  moments.variance = std::max(moments.variance, standard_error);
  return moments;
}

std::vector<double> VarianceComponents(const std::vector<double>& differences,
                                       const std::vector<std::vector<double>>& columns) {
  const auto count = static_cast<Eigen::Index>(columns.size());
  std::vector<double> coefficients(columns.size(), 0.0);
  if (differences.empty()) return coefficients;
  const double width = ClipWidth(differences, 0.0);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count), row(count);
  for (std::size_t i = 0; i < differences.size(); ++i) {
    if (std::abs(differences[i]) > width) continue;
    for (Eigen::Index c = 0; c < count; ++c) row[c] = columns[static_cast<std::size_t>(c)][i];
    normal += row * row.transpose();
    right += differences[i] * differences[i] * row;
  }
  double most = 0;  // that a fit takes off the sum of squares
  for (unsigned subset = 1; subset < 1U << count; ++subset) {
    const std::optional<Eigen::VectorXd> fit = FitSubset(normal, right, subset);
    if (!fit || fit->minCoeff() < 0 || !(fit->dot(right) > most * (1 + 1e-9))) continue;
    most = fit->dot(right);
    coefficients.assign(fit->begin(), fit->end());
  }
  return coefficients;
}

std::vector<double> RelativeVarianceComponents(const std::vector<double>& differences,
                                               const std::vector<std::vector<double>>& columns) {
  constexpr int kRounds = 10;
  std::vector<double> fit = VarianceComponents(differences, columns);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> whitened;
    std::vector<std::vector<double>> relative(columns.size());
    for (std::size_t i = 0; i < differences.size(); ++i) {
      double variance = 0;
      for (std::size_t c = 0; c < columns.size(); ++c) variance += fit[c] * columns[c][i];
      if (!(variance > 0)) continue;
      whitened.push_back(differences[i] / std::sqrt(variance));
      for (std::size_t c = 0; c < columns.size(); ++c) {
        relative[c].push_back(columns[c][i] / variance);
      }
    }
    if (whitened.empty()) break;
    fit = VarianceComponents(whitened, relative);
  }
  return fit;
}

Line VarianceOverLag(const std::vector<double>& differences, const std::vector<double>& lag_s) {
  const std::vector<double> ones(differences.size(), 1.0);
  const std::vector<double> fit = VarianceComponents(differences, {ones, lag_s});
  return {fit[0], fit[1]};
}

}  // namespace walkgraph
