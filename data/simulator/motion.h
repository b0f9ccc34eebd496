#ifndef WALKGRAPH_DATA_SIMULATOR_MOTION_H_
#define WALKGRAPH_DATA_SIMULATOR_MOTION_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "data/simulator/random.h"
#include "data/simulator/route.h"
#include "data/simulator/settings.h"
#include "data/time.h"

namespace walkgraph {

// How long a person stands where a walk ends, and before it where nothing else happens there.
inline constexpr double kStandAtEndsS = 1.5;

enum class Activity : std::uint8_t { kStand, kWalk, kStairs, kLift, kEscalator };

// The person at one instant.
struct WalkState {
  TimeNs time_ns = 0;
  double distance_m = 0;  // along the routes
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  double height_m = 0;     // of the feet
  double heading_rad = 0;  // of walking, counter-clockwise from +x, unwrapped
  double speed_mps = 0;    // seen from above
  double step_phase = 0;   // grows by one with every step; whole numbers are heel strikes
  Activity activity = Activity::kStand;
};

// How one person walks.
struct Gait {
  double step_rate_hz = 0;
  double step_length_m = 0;
  double step_length_sigma_m = 0;  // from step to step
};

// A person drawn at random.
Gait RandomGait(const GaitSettings& settings, Random* random);

// A stop on the way.
struct Stop {
  double distance_m = 0;
  double duration_s = 0;
};

// A ride in a lift from standstill to standstill: the speed rises and falls like half a cosine.
class LiftRide {
 public:
  LiftRide(double rise_m, const RideSettings& settings);
  double duration_s() const { return 2.0 * ramp_s_ + cruise_s_; }
  // Height above the start, `time_s` after it; the whole rise behind the end.
  double HeightAt(double time_s) const;

 private:
  double RampHeight(double time_s) const;

  double rise_m_;
  double speed_mps_ = 0;  // with the sign of the rise
  double ramp_s_ = 0;
  double cruise_s_ = 0;
};

// A path that is walked without a break, and what happens where it ends.
struct Leg {
  Route route;
  std::vector<Stop> stops = {};  // by distance
  double lift_rise_m = 0;        // of the lift that the path ends in; 0 where it is none
};

// Walks the legs: stands, goes, stops, turns on the spot between legs, rides, stands. One state
// every `interval_ns` from `begin_ns`; the first step comes `wait_s` later. Gait and rides are
// those of `settings`.
std::vector<WalkState> WalkLegs(const std::vector<Leg>& legs, const Gait& gait,
                                const SimulationSettings& settings, double wait_s, TimeNs begin_ns,
                                TimeNs interval_ns, Random* random);

// Gives a path the inertia of a body: positions, heights and headings are averaged over `window_s`,
// twice, so that where straight lines and arcs meet no force becomes infinite.
void SmoothPath(double window_s, std::vector<WalkState>* states);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_MOTION_H_
