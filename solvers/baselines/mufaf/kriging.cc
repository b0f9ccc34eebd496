#include "solvers/baselines/mufaf/kriging.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace walkgraph {
namespace {

// Semivariances between positions, and of each to the target.
struct Semivariances {
  Eigen::MatrixXd between;
  Eigen::VectorXd to_target;
};

Semivariances Evaluate(const SphericalVariogram& variogram,
                       const std::vector<Eigen::Vector2d>& positions_m,
                       const Eigen::Vector2d& target_m) {
  const auto n = static_cast<Eigen::Index>(positions_m.size());
  Semivariances gamma{Eigen::MatrixXd(n, n), Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d& at = positions_m[static_cast<std::size_t>(i)];
    gamma.to_target(i) = variogram((at - target_m).norm());
    for (Eigen::Index j = 0; j < n; ++j) {
      gamma.between(i, j) = variogram((at - positions_m[static_cast<std::size_t>(j)]).norm());
    }
  }
  return gamma;
}

// Share of the partial sill at a distance.
double SphericalShare(double distance_m, double range_m) {
  const double h = std::min(1.0, distance_m / range_m);
  return 1.5 * h - 0.5 * h * h * h;
}

// Nugget and partial sill that fit best at one range, and the weighted squares that are left.
struct Fit {
  SphericalVariogram variogram;
  double squares = std::numeric_limits<double>::infinity();
};

Fit FitAtRange(const EmpiricalVariogram& measured, double range_m) {
  double w = 0, ws = 0, wss = 0, wg = 0, wsg = 0;
  for (std::size_t i = 0; i < measured.gamma.size(); ++i) {
    const double pairs = measured.pairs[i], gamma = measured.gamma[i];
    const double share = SphericalShare(measured.distance_m[i], range_m);
    w += pairs;
    ws += pairs * share;
    wss += pairs * share * share;
    wg += pairs * gamma;
    wsg += pairs * share * gamma;
  }
  const double determinant = w * wss - ws * ws;
  double sill = determinant > 0 ? (w * wsg - ws * wg) / determinant : 0.0;
  double nugget = (wg - sill * ws) / w;
  if (nugget < 0) {
    nugget = 0;
    sill = wss > 0 ? wsg / wss : 0.0;
  } else if (sill < 0) {
    sill = 0;
    nugget = wg / w;
  }
  Fit fit{{nugget, sill, range_m}, 0};
  for (std::size_t i = 0; i < measured.gamma.size(); ++i) {
    const double left =
        measured.gamma[i] - nugget - sill * SphericalShare(measured.distance_m[i], range_m);
    fit.squares += measured.pairs[i] * left * left;
  }
  return fit;
}

}  // namespace

double SphericalVariogram::operator()(double distance_m) const {
  if (distance_m <= 0) return 0;
  return nugget + partial_sill * SphericalShare(distance_m, range_m);
}

EmpiricalVariogram MeasureVariogram(const std::vector<Eigen::Vector2d>& positions_m,
                                    const Eigen::VectorXd& values, int bins) {
  double largest_m = 0;
  for (const Eigen::Vector2d& a : positions_m) {
    for (const Eigen::Vector2d& b : positions_m) largest_m = std::max(largest_m, (a - b).norm());
  }
  const double width_m = largest_m / 2 / bins;
  std::vector<double> pairs(static_cast<std::size_t>(bins), 0.0), distance = pairs, gamma = pairs;
  for (std::size_t i = 0; i < positions_m.size(); ++i) {
    for (std::size_t j = i + 1; j < positions_m.size(); ++j) {
      const double d = (positions_m[i] - positions_m[j]).norm();
      const auto bin = static_cast<std::size_t>(d / width_m);
      if (!(d > 0) || bin >= pairs.size()) continue;
      const double difference =
          values(static_cast<Eigen::Index>(i)) - values(static_cast<Eigen::Index>(j));
      ++pairs[bin];
      distance[bin] += d;
      gamma[bin] += difference * difference / 2;
    }
  }
  EmpiricalVariogram measured;
  for (std::size_t b = 0; b < pairs.size(); ++b) {
    if (pairs[b] == 0) continue;
    measured.distance_m.push_back(distance[b] / pairs[b]);
    measured.gamma.push_back(gamma[b] / pairs[b]);
    measured.pairs.push_back(pairs[b]);
  }
  return measured;
}

SphericalVariogram FitSpherical(const EmpiricalVariogram& measured) {
  constexpr int kRanges = 40;
  if (measured.gamma.empty()) return {1, 0, 1};
  const double longest_m =
      2 * *std::max_element(measured.distance_m.begin(), measured.distance_m.end());
  Fit best;
  for (int i = 1; i <= kRanges; ++i) {
    const Fit fit = FitAtRange(measured, longest_m * i / kRanges);
    if (fit.squares < best.squares) best = fit;
  }
  // All values alike: any weights serve, a singular system does not.
  if (!(best.variogram.Sill() > 0)) best.variogram.nugget = 1;
  return best.variogram;
}

Interpolated OrdinaryKriging(const SphericalVariogram& variogram,
                             const std::vector<Eigen::Vector2d>& positions_m,
                             const Eigen::VectorXd& values, const Eigen::Vector2d& target_m) {
  const Semivariances gamma = Evaluate(variogram, positions_m, target_m);
  const Eigen::Index n = values.size();
  Eigen::MatrixXd system = Eigen::MatrixXd::Ones(n + 1, n + 1);
  system.topLeftCorner(n, n) = gamma.between;
  system(n, n) = 0;
  Eigen::VectorXd right(n + 1);
  right << gamma.to_target, 1;
  const Eigen::VectorXd solution = system.fullPivLu().solve(right);
  Interpolated result;
  result.weights = solution.head(n);
  result.multiplier = solution(n);
  result.value = result.weights.dot(values);
  result.variance = result.weights.dot(gamma.to_target) + result.multiplier;
  return result;
}

Interpolated CovarianceInterpolation(const SphericalVariogram& variogram, double mean,
                                     const std::vector<Eigen::Vector2d>& positions_m,
                                     const Eigen::VectorXd& values,
                                     const Eigen::Vector2d& target_m) {
  const Semivariances gamma = Evaluate(variogram, positions_m, target_m);
  const double sill = variogram.Sill();
  const Eigen::MatrixXd between = sill - gamma.between.array();
  const Eigen::VectorXd to_target = sill - gamma.to_target.array();
  Interpolated result;
  result.weights = between.fullPivLu().solve(to_target);
  result.value = mean + result.weights.dot((values.array() - mean).matrix());
  result.variance = sill - result.weights.dot(to_target);
  return result;
}

}  // namespace walkgraph
