#include "eval/honesty/planned_inputs.h"

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

#include "data/angle.h"

namespace walkgraph {
namespace {

constexpr TimeNs kBeginNs = 1'700'000'000 * kNsPerSecond;
constexpr double kStepLengthM = 0.7;
constexpr double kStepS = kStepLengthM / kPlannedSpeedMps;
constexpr double kHalfBoxM = 12;

class Planner {
 public:
  Planner(double duration_s, Random* random)
      : random_(*random), end_ns_(kBeginNs + DurationNs(duration_s)) {
    evidence_.begin_ns = kBeginNs;
    evidence_.gyro_yaw_rad.push_back(kBeginNs, 0);
  }

  Evidence Plan() && {
    while (now_ns_ < end_ns_) {
      const int steps = 6 + random_.Index(9);
      const double turn_rad = ChooseTurn(steps);
      Walk(steps, turn_rad);
      if (random_.Uniform() < 0.3) Pause(random_.Uniform(3, 8));
    }
    evidence_.end_ns = now_ns_;
    return std::move(evidence_);
  }

 private:
  Eigen::Vector2d Ahead(double heading_rad, int steps) const {
    return position_m_ + steps * kStepLengthM * DirectionOf(heading_rad);
  }

  // A turn after which the leg stays inside the box; back where none does.
  double ChooseTurn(int steps) {
    std::vector<double> inside;
    for (const double turn_rad : {0.5 * std::numbers::pi, -0.5 * std::numbers::pi}) {
      if (Ahead(heading_rad_ + turn_rad, steps).cwiseAbs().maxCoeff() < kHalfBoxM) {
        inside.push_back(turn_rad);
      }
    }
    if (inside.empty() || random_.Uniform() < 0.1) return std::numbers::pi;
    return inside[static_cast<std::size_t>(random_.Index(static_cast<int>(inside.size())))];
  }

  // The turn is spread over the leg's first steps.
  void Walk(int steps, double turn_rad) {
    constexpr int kTurningSteps = 3;
    const TimeNs from_ns = now_ns_;
    for (int step = 0; step < steps; ++step) {
      if (step < kTurningSteps) heading_rad_ += turn_rad / kTurningSteps;
      const TimeNs next_ns = now_ns_ + DurationNs(kStepS);
      evidence_.steps.push_back({now_ns_, next_ns, kStepLengthM});
      position_m_ = Ahead(heading_rad_, 1);
      now_ns_ = next_ns;
      evidence_.gyro_yaw_rad.push_back(now_ns_, heading_rad_);
    }
    evidence_.motion.push_back({from_ns, now_ns_, MotionState::kWalking});
  }

  void Pause(double seconds) {
    const TimeNs from_ns = now_ns_;
    now_ns_ += DurationNs(seconds);
    evidence_.motion.push_back({from_ns, now_ns_, MotionState::kStanding});
    evidence_.gyro_yaw_rad.push_back(now_ns_, heading_rad_);
  }

  Random& random_;
  TimeNs end_ns_;
  TimeNs now_ns_ = kBeginNs;
  double heading_rad_ = 0;
  Eigen::Vector2d position_m_ = Eigen::Vector2d::Zero();
  Evidence evidence_;
};

}  // namespace

Evidence PlanInputs(double duration_s, Random* random) {
  return Planner(duration_s, random).Plan();
}

}  // namespace walkgraph
