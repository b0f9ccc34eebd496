#ifndef WALKGRAPH_EVAL_METRICS_H_
#define WALKGRAPH_EVAL_METRICS_H_

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "data/trajectory.h"
#include "data/truth.h"

namespace walkgraph {

// How far an estimate is from one waypoint.
struct WaypointError {
  double error_m = 0;  // horizontal distance
  int floor = 0;       // the true one
  int floors_off = 0;  // between the estimated floor and the true one, not negative
  // Normalised estimation error squared, e^T S^-1 e with S the estimate's covariance plus the
  // waypoint's own; mean 2 where S is right. NaN where the method has no covariance.
  double nees = std::numeric_limits<double>::quiet_NaN();
  // Root mean square of the error that the estimate's covariance claims, m; NaN as above.
  double claimed_m = std::numeric_limits<double>::quiet_NaN();
};

// Errors of a trajectory at the waypoints' times (clamped at its ends). `truth` is in the building
// frame; `truth_sigma_m` is the waypoints' own error per axis, so that a perfect estimate is not
// called overconfident. Precondition: the trajectory is not empty.
std::vector<WaypointError> ErrorsAtWaypoints(const Trajectory& trajectory, const Truth& truth,
                                             double truth_sigma_m);

// The errors of a method that answers `position` and nothing else: no covariance, floor wrong
// unless it is `floor`.
std::vector<WaypointError> ErrorsOfFixedPoint(const Eigen::Vector2d& position, int floor,
                                              const Truth& truth);

// Statistics of errors in metres. Everything is NaN where there is nothing to take it of; coverage
// and NEES are over the waypoints with a covariance.
struct ErrorSummary {
  int n = 0;
  double mean_m = std::numeric_limits<double>::quiet_NaN();
  double rmse_m = std::numeric_limits<double>::quiet_NaN();
  double median_m = std::numeric_limits<double>::quiet_NaN();
  double p75_m = std::numeric_limits<double>::quiet_NaN();
  double p90_m = std::numeric_limits<double>::quiet_NaN();
  double p95_m = std::numeric_limits<double>::quiet_NaN();
  double max_m = std::numeric_limits<double>::quiet_NaN();
  double floor_accuracy = std::numeric_limits<double>::quiet_NaN();
  // The score of the IPIN competitions: the 75th percentile of the error plus 15 m for every floor
  // that the estimate is off (Potorti et al. 2017, Comparing the performance of indoor localization
  // systems through the EvAAL framework, Sensors 17).
  double ipin_m = std::numeric_limits<double>::quiet_NaN();
  // Share of waypoints inside the 50 % and 95 % ellipses of the 2-D normal distribution. These and
  // the NEES are of the waypoints where the estimate has a covariance, if they are at least half of
  // all: a method that claims none but where it has nothing to go by would be scored on that alone.
  double coverage50 = std::numeric_limits<double>::quiet_NaN();
  double coverage95 = std::numeric_limits<double>::quiet_NaN();
  double nees = std::numeric_limits<double>::quiet_NaN();  // mean; 2 where the covariance is right
};

ErrorSummary Summarise(const std::vector<WaypointError>& errors);

// The p-quantile (p in [0, 1]) by linear interpolation between order statistics: of n sorted values
// x[0..n-1] the value at rank p (n - 1). Precondition: sorted ascending, not empty.
double Quantile(const std::vector<double>& sorted, double p);

// Squared Mahalanobis radius within which a 2-D normal variable falls with probability p.
double ChiSquare2Quantile(double p);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_METRICS_H_
