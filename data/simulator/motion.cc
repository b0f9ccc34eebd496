#include "data/simulator/motion.h"

#include <algorithm>
#include <cmath>

#include "data/angle.h"

namespace walkgraph {
namespace {

// Preferred walking of healthy adults: 1.3 m/s at some 1.85 steps per second, step length varying
// by 3-4 % from step to step (Oberg, Karsznia and Oberg, J. Rehabil. Res. Dev. 30, 1993; Hausdorff,
// J. NeuroEng. Rehabil. 2, 2005). A person who watches a phone is a little slower.
constexpr double kStepRateHz = 1.8;
constexpr double kStepRateSigmaHz = 0.07;
constexpr double kStepLengthM = 0.68;
constexpr double kStepLengthSigmaM = 0.03;
constexpr double kStepVariation = 0.035;

constexpr double kStandAtEndsS = 1.5;
constexpr double kSpeedTimeConstantS = 0.35;  // gait starts and stops within one or two steps
constexpr double kStandingSpeedMps = 0.02;    // slower than this the feet rest

}  // namespace

Gait RandomGait(Random* random) {
  Gait gait;
  gait.step_rate_hz = random->Normal(kStepRateHz, kStepRateSigmaHz);
  gait.step_length_m = random->Normal(kStepLengthM, kStepLengthSigmaM);
  gait.step_length_sigma_m = kStepVariation * gait.step_length_m;
  return gait;
}

std::vector<WalkState> WalkRoute(const Route& route, const Gait& gait, const Stop& stop,
                                 TimeNs begin_ns, TimeNs interval_ns, Random* random) {
  std::vector<WalkState> states;
  const double dt = SecondsBetween(0, interval_ns);
  double standing_s = kStandAtEndsS;
  bool stopped = false;
  bool arrived = false;
  double this_step_m = gait.step_length_m;
  WalkState state;
  state.time_ns = begin_ns;
  state.heading_rad = route.HeadingAt(0);
  while (true) {
    state.position_m = route.At(state.distance_m);
    const double turn = WrapAngle(route.HeadingAt(state.distance_m) - state.heading_rad);
    state.heading_rad += turn;
    states.push_back(state);

    // The distance in which the low-pass filter brings the person to rest.
    const double braking_m = state.speed_mps * kSpeedTimeConstantS;
    if (!stopped && state.distance_m + braking_m >= stop.distance_m) {
      stopped = true;
      standing_s = stop.duration_s;
    }
    if (!arrived && state.distance_m + braking_m >= route.length_m()) {
      arrived = true;
      standing_s = kStandAtEndsS;
    }
    standing_s = std::max(0.0, standing_s - dt);
    if (arrived && standing_s == 0.0) return states;

    const double target_mps = standing_s > 0.0 ? 0.0 : gait.step_rate_hz * this_step_m;
    state.speed_mps += (target_mps - state.speed_mps) * (1.0 - std::exp(-dt / kSpeedTimeConstantS));
    if (target_mps == 0.0 && state.speed_mps < kStandingSpeedMps) state.speed_mps = 0.0;
    const double before = std::floor(state.step_phase);
    state.step_phase += state.speed_mps / this_step_m * dt;
    if (std::floor(state.step_phase) > before) {
      this_step_m = random->Normal(gait.step_length_m, gait.step_length_sigma_m);
    }
    state.distance_m += state.speed_mps * dt;
    state.time_ns += interval_ns;
  }
}

}  // namespace walkgraph
