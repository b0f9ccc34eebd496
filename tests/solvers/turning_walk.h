#ifndef WALKGRAPH_TESTS_SOLVERS_TURNING_WALK_H_
#define WALKGRAPH_TESTS_SOLVERS_TURNING_WALK_H_

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "data/time.h"
#include "data/truth.h"
#include "frontends/evidence/evidence.h"

namespace walkgraph::testing {

// A walk without any noise: ten seconds straight on, a left turn of 90 degrees within two seconds,
// ten seconds straight on, in steps of half a second and 0.7 m. Sensors run all the time and tell
// the truth.
struct TurningWalk {
  static constexpr TimeNs kStart = 1'560'000'000 * kNsPerSecond;
  static constexpr double kEndS = 22, kStepS = 0.5, kStepM = 0.7;

  static TimeNs At(double seconds) { return kStart + DurationNs(seconds); }

  // `rotation_rad` turns the building against the compass.
  explicit TurningWalk(double rotation_rad = 0) : rotation_rad_(rotation_rad) {
    evidence.begin_ns = At(0);
    evidence.end_ns = At(kEndS);
    evidence.motion.push_back({At(0), At(kEndS), MotionState::kWalking});
    positions_m.emplace_back(3, 4);
    for (int i = 0; i < static_cast<int>(kEndS / kStepS); ++i) {
      const double begin_s = i * kStepS, end_s = begin_s + kStepS;
      evidence.steps.push_back({At(begin_s), At(end_s), kStepM});
      const double heading = 0.5 * (Heading(begin_s) + Heading(end_s));
      positions_m.push_back(positions_m.back() +
                            kStepM * Eigen::Vector2d(std::cos(heading), std::sin(heading)));
    }
    for (int i = 0; i <= static_cast<int>(10 * kEndS); ++i) {
      const double compass = Heading(0.1 * i) - rotation_rad_;
      evidence.gyro_yaw_rad.push_back(At(0.1 * i), compass - Heading(0) + rotation_rad_);
      evidence.absolute_heading_rad.push_back(At(0.1 * i), compass);
      evidence.absolute_heading_sigma_rad.push_back(0.05);
    }
  }

  double Heading(double seconds) const {
    const double turned = std::clamp((seconds - 10) / 2, 0.0, 1.0);
    return rotation_rad_ + 0.5 * std::numbers::pi * turned;
  }

  // Precondition: a multiple of kStepS.
  Eigen::Vector2d Position(double seconds) const {
    return positions_m[static_cast<std::size_t>(std::lround(seconds / kStepS))];
  }

  Truth WaypointsAt(const std::vector<double>& seconds) const {
    Truth truth;
    for (const double s : seconds) truth.waypoints.push_back({At(s), Position(s), 0});
    return truth;
  }

  void ForgetAbsoluteHeading() {
    evidence.absolute_heading_rad = {};
    evidence.absolute_heading_sigma_rad.clear();
  }

  Evidence evidence;
  std::vector<Eigen::Vector2d> positions_m;  // at the begin and after each step

 private:
  double rotation_rad_;
};

}  // namespace walkgraph::testing

#endif  // WALKGRAPH_TESTS_SOLVERS_TURNING_WALK_H_
