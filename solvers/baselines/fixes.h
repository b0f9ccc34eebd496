#ifndef WALKGRAPH_SOLVERS_BASELINES_FIXES_H_
#define WALKGRAPH_SOLVERS_BASELINES_FIXES_H_

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "data/time.h"
#include "data/trajectory.h"
#include "factors/dead_reckoning.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"
#include "solvers/estimator.h"

namespace walkgraph {

// A position at one moment, as the methods without a motion model between epochs produce them.
struct PositionFix {
  TimeNs time_ns = 0;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  int floor = 0;
  Eigen::Matrix2d covariance_m2 =
      Eigen::Matrix2d::Constant(std::numeric_limits<double>::quiet_NaN());
};

// Begin, every whole second after it, end, and the given times that lie within: sorted, each once.
std::vector<TimeNs> NodeTimes(const Evidence& evidence, std::vector<TimeNs> more);

// Poses at NodeTimes: position and covariance linear in time between fixes and clamped outside,
// floor of the nearer fix, z the height of the floor. The heading is the walking direction, or
// without it the direction from fix to fix. `fixes` are in order of time (of equal times the first
// counts) and not empty.
Trajectory TrajectoryFromFixes(const Site& site, const Evidence& evidence,
                               const DeadReckonedPath& path, const std::vector<PositionFix>& fixes);

// Where somebody is of whom nothing is known: the mean and covariance of the survey's path on the
// floor (without a floor, on the floor with the longest path), or of the floor's bounding box where
// nobody surveyed.
PositionFix SurveyCentroid(const Site& site, std::optional<int> floor);

// The result for a walk that cannot be placed: the centroid throughout, status unobservable.
EstimateResult UnlocatedResult(const Site& site, const Evidence& evidence,
                               const DeadReckonedPath& path, const std::string& message);

double FloorHeight(const Site& site, int floor);  // 0 for a floor that the building does not name

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_FIXES_H_
