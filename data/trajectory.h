#ifndef WALKGRAPH_DATA_TRAJECTORY_H_
#define WALKGRAPH_DATA_TRAJECTORY_H_

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "data/time.h"

namespace walkgraph {

// An estimated pose with its marginal covariance. Methods that have no covariance leave it NaN.
struct PoseEstimate {
  TimeNs time_ns = 0;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  // building frame, z up
  int floor = 0;
  double heading_rad = 0;  // of walking, counter-clockwise from +x, unwrapped along the trajectory
  Eigen::Matrix2d covariance_xy_m2 =
      Eigen::Matrix2d::Constant(std::numeric_limits<double>::quiet_NaN());
  double variance_z_m2 = std::numeric_limits<double>::quiet_NaN();
  double variance_heading_rad2 = std::numeric_limits<double>::quiet_NaN();
  int modes = 1;  // competing hypotheses that this row's covariance mixes
};

// Poses in strictly increasing order of time.
struct Trajectory {
  std::vector<PoseEstimate> poses;

  bool empty() const { return poses.empty(); }

  // Position, heading and covariance linear in time between the bracketing poses; floor and modes
  // of the nearer one; clamped at the ends. Throws std::logic_error on an empty trajectory.
  PoseEstimate At(TimeNs time_ns) const;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_TRAJECTORY_H_
