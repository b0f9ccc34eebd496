#include "eval/metrics.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace walkgraph {
namespace {

double Nees(const Eigen::Vector2d& error, const Eigen::Matrix2d& covariance) {
  const double determinant = covariance.determinant();
  // Also catches NaN, the sign of a method without covariance.
  if (!(determinant > 0)) return std::numeric_limits<double>::quiet_NaN();
  return error.dot(covariance.inverse() * error);
}

}  // namespace

std::vector<WaypointError> ErrorsAtWaypoints(const Trajectory& trajectory, const Truth& truth,
                                             double truth_sigma_m) {
  const Eigen::Matrix2d truth_covariance =
      truth_sigma_m * truth_sigma_m * Eigen::Matrix2d::Identity();
  std::vector<WaypointError> errors;
  for (const Waypoint& waypoint : truth.waypoints) {
    const PoseEstimate pose = trajectory.At(waypoint.time_ns);
    const Eigen::Vector2d difference = pose.position_m.head<2>() - waypoint.position;
    WaypointError error;
    error.error_m = difference.norm();
    error.floor = waypoint.floor;
    error.floors_off = std::abs(pose.floor - waypoint.floor);
    error.claimed_m = std::sqrt(pose.covariance_xy_m2.trace());
    error.nees = Nees(difference, pose.covariance_xy_m2 + truth_covariance);
    errors.push_back(error);
  }
  return errors;
}

std::vector<WaypointError> ErrorsOfFixedPoint(const Eigen::Vector2d& position, int floor,
                                              const Truth& truth) {
  std::vector<WaypointError> errors;
  for (const Waypoint& waypoint : truth.waypoints) {
    WaypointError error;
    error.error_m = (position - waypoint.position).norm();
    error.floor = waypoint.floor;
    error.floors_off = std::abs(floor - waypoint.floor);
    errors.push_back(error);
  }
  return errors;
}

double Quantile(const std::vector<double>& sorted, double p) {
  const double rank = p * static_cast<double>(sorted.size() - 1);
  const std::size_t below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (rank - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

double ChiSquare2Quantile(double p) {
  return -2.0 * std::log1p(-p);  // the chi-square distribution with two degrees is exponential
}

ErrorSummary Summarise(const std::vector<WaypointError>& errors) {
  ErrorSummary summary;
  summary.n = static_cast<int>(errors.size());
  if (errors.empty()) return summary;
  constexpr double kFloorPenaltyM = 15.0;
  std::vector<double> sorted, penalised;
  double sum = 0, sum_of_squares = 0, sum_of_nees = 0;
  int floors_correct = 0, with_covariance = 0, inside50 = 0, inside95 = 0;
  for (const WaypointError& error : errors) {
    sorted.push_back(error.error_m);
    sum += error.error_m;
    sum_of_squares += error.error_m * error.error_m;
    floors_correct += error.floors_off == 0 ? 1 : 0;
    penalised.push_back(error.error_m + kFloorPenaltyM * error.floors_off);
    if (std::isnan(error.nees)) continue;
    ++with_covariance;
    sum_of_nees += error.nees;
    inside50 += error.nees <= ChiSquare2Quantile(0.50) ? 1 : 0;
    inside95 += error.nees <= ChiSquare2Quantile(0.95) ? 1 : 0;
  }
  std::sort(sorted.begin(), sorted.end());
  summary.mean_m = sum / summary.n;
  summary.rmse_m = std::sqrt(sum_of_squares / summary.n);
  summary.median_m = Quantile(sorted, 0.50);
  summary.p75_m = Quantile(sorted, 0.75);
  summary.p90_m = Quantile(sorted, 0.90);
  summary.p95_m = Quantile(sorted, 0.95);
  summary.max_m = sorted.back();
  std::sort(penalised.begin(), penalised.end());
  summary.ipin_m = Quantile(penalised, 0.75);
  summary.floor_accuracy = static_cast<double>(floors_correct) / summary.n;
  if (2 * with_covariance >= summary.n) {
    summary.coverage50 = static_cast<double>(inside50) / with_covariance;
    summary.coverage95 = static_cast<double>(inside95) / with_covariance;
    summary.nees = sum_of_nees / with_covariance;
  }
  return summary;
}

}  // namespace walkgraph
