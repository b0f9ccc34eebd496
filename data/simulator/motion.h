#ifndef WALKGRAPH_DATA_SIMULATOR_MOTION_H_
#define WALKGRAPH_DATA_SIMULATOR_MOTION_H_

#include <Eigen/Core>
#include <vector>

#include "data/simulator/random.h"
#include "data/simulator/route.h"
#include "data/time.h"

namespace walkgraph {

// The person at one instant.
struct WalkState {
  TimeNs time_ns = 0;
  double distance_m = 0;  // along the route
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  double heading_rad = 0;  // of walking, counter-clockwise from +x, unwrapped
  double speed_mps = 0;
  double step_phase = 0;  // grows by one with every step; whole numbers are heel strikes
};

// How one person walks.
struct Gait {
  double step_rate_hz = 0;
  double step_length_m = 0;
  double step_length_sigma_m = 0;  // from step to step
};

// A person drawn at random.
Gait RandomGait(Random* random);

// A stop on the way; the person stands at the ends of the route anyway.
struct Stop {
  double distance_m = 0;
  double duration_s = 0;
};

// Walks the route: stands, goes, stops, stands. One state every `interval_ns` from `begin_ns`.
std::vector<WalkState> WalkRoute(const Route& route, const Gait& gait, const Stop& stop,
                                 TimeNs begin_ns, TimeNs interval_ns, Random* random);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_MOTION_H_
