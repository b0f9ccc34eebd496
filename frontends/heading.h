#ifndef WALKGRAPH_FRONTENDS_HEADING_H_
#define WALKGRAPH_FRONTENDS_HEADING_H_

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "data/recording.h"
#include "frontends/settings.h"

namespace walkgraph {

// Direction of walking in the east-north frame (radians counter-clockwise from magnetic east,
// unwrapped), with its own sigma per sample.
struct HeadingStream {
  Stream<double> heading_rad;
  std::vector<double> sigma_rad;
};

// The walking direction is taken as the horizontal direction at right angles to the device's x
// axis. Held flat that is where the top of the screen (+y) points, held upright where its back (-z)
// looks, and in between both and this direction are the same: no decision is needed. Where x is
// within about 17 degrees of the vertical (landscape) there is no such direction; these samples are
// dropped and counted as "heading_undefined".
//
// From the rotation vector, else from the magnetometer compensated by `up`; empty where neither is
// there. The sigma is what the heading drifts against the gyroscope (`yaw_rad`) inside the
// settings' window: a magnetic disturbance turns the one and not the other. Without gyroscope it is
// zero.
HeadingStream AbsoluteHeading(const Recording& recording, const Stream<Eigen::Vector3d>& up,
                              const Stream<double>& yaw_rad, const HeadingQualitySettings& settings,
                              std::map<std::string, std::int64_t>* counts);

// From the one source only; without sigma.
Stream<double> RotationVectorHeading(const Stream<Eigen::Quaterniond>& rotation_vector,
                                     std::map<std::string, std::int64_t>* counts);
Stream<double> MagnetometerHeading(const Stream<Eigen::Vector3d>& magnetometer_ut,
                                   const Stream<Eigen::Vector3d>& up,
                                   std::map<std::string, std::int64_t>* counts);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_HEADING_H_
