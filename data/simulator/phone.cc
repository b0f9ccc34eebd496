#include "data/simulator/phone.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "data/angle.h"
#include "data/simulator/noise.h"

namespace walkgraph {
namespace {

constexpr double kGravityMps2 = 9.80665;
constexpr double kTurn = 2.0 * std::numbers::pi;

// Forward and sideways acceleration of the trunk against the vertical one (Zijlstra and Hof, Gait
// and Posture 18, 2003): forward about half, with the steps; sideways a quarter, with the strides.
constexpr double kForwardShare = 0.5;
constexpr double kSidewaysShare = 0.25;
constexpr double kSecondHarmonicShare = 0.2;

// Streams of random numbers beside the main one.
enum RandomStream : std::uint64_t { kAccelerationBias };

bool TakesSteps(const WalkState& state) {
  return state.activity == Activity::kWalk || state.activity == Activity::kStairs;
}

// How strongly the person walks at this moment: 0 standing, 1 at the usual speed on a floor.
double Effort(const WalkState& state, const Gait& gait) {
  if (!TakesSteps(state)) return 0.0;
  return std::min(1.2, state.speed_mps / (gait.step_rate_hz * gait.step_length_m));
}

// Acceleration of the path between three states, by second differences.
Eigen::Vector3d PathAcceleration(const std::vector<WalkState>& states, std::size_t i, double dt_s) {
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  if (i == 0 || i + 1 >= states.size()) return acceleration;
  const WalkState& before = states[i - 1];
  const WalkState& after = states[i + 1];
  acceleration.head<2>() =
      (after.position_m - 2.0 * states[i].position_m + before.position_m) / (dt_s * dt_s);
  acceleration.z() = (after.height_m - 2.0 * states[i].height_m + before.height_m) / (dt_s * dt_s);
  return acceleration;
}

class GaitAcceleration {
 public:
  GaitAcceleration(const Gait& gait, const GaitSettings& settings, double weinberg_k)
      : gait_(gait),
        settings_(settings),
        level_swing_mps2_(std::pow(gait.step_length_m / weinberg_k, 4.0)) {}

  // Of the trunk around the path, in building axes.
  Eigen::Vector3d At(const std::vector<WalkState>& states, std::size_t i) const {
    const WalkState& state = states[i];
    const double amplitude = 0.5 * Swing(states, i);
    const double phase = kTurn * state.step_phase;
    const Eigen::Vector2d forward = DirectionOf(state.heading_rad);
    const Eigen::Vector2d left(-forward.y(), forward.x());
    Eigen::Vector3d acceleration;
    acceleration.head<2>() = kForwardShare * amplitude * std::sin(phase) * forward +
                             kSidewaysShare * amplitude * std::sin(0.5 * phase) * left;
    acceleration.z() = amplitude * (std::cos(phase) + kSecondHarmonicShare * std::sin(2.0 * phase));
    return acceleration;
  }

 private:
  // Between the lowest and the highest vertical acceleration of a step.
  double Swing(const std::vector<WalkState>& states, std::size_t i) const {
    const WalkState& state = states[i];
    if (state.activity != Activity::kStairs) return level_swing_mps2_ * Effort(state, gait_);
    const bool up = i == 0 || state.height_m >= states[i - 1].height_m;
    const double rate_hz = up ? settings_.stairs_up_rate_hz : settings_.stairs_down_rate_hz;
    const double swing = up ? settings_.stairs_up_swing_mps2 : settings_.stairs_down_swing_mps2;
    return swing * std::min(1.2, state.speed_mps / (rate_hz * settings_.tread_m));
  }

  Gait gait_;
  GaitSettings settings_;
  double level_swing_mps2_;
};

// Mean angular rate from one attitude to another, axes of the first.
Eigen::Vector3d AngularRate(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to,
                            double dt_s) {
  const Eigen::AngleAxisd turn(from.conjugate() * to);
  const double angle = WrapAngle(turn.angle());
  return turn.axis() * (angle / dt_s);
}

}  // namespace

std::vector<Eigen::Quaterniond> SimulateAttitudes(const std::vector<WalkState>& states,
                                                  const Gait& gait, const HoldSettings& settings,
                                                  const Handling& handling, Random* random) {
  const double dt_s = SecondsBetween(states[0].time_ns, states[1].time_ns);
  const double hold = random->Normal(0.0, settings.offset_sigma_rad);
  const double pitch = random->Normal(settings.pitch_rad, settings.pitch_sigma_rad);
  const double roll = random->Normal(0.0, settings.roll_sigma_rad);
  Wander hand(settings.wander_rad, settings.wander_s, dt_s, random);
  // A hand has mass: what it wanders is smoothed to below the frequency of the steps.
  double smooth_hand = 0;
  const double smoothing = 1.0 - std::exp(-dt_s / 0.5);
  std::vector<Eigen::Quaterniond> attitudes;
  attitudes.reserve(states.size());
  for (const WalkState& state : states) {
    const double sway = Effort(state, gait) * settings.sway_rad;
    smooth_hand += smoothing * (hand.Next(random) - smooth_hand);
    const double stride = std::sin(0.5 * kTurn * state.step_phase);
    const double yaw = state.heading_rad + hold + smooth_hand + sway * stride;
    const double nod = pitch + sway * std::cos(kTurn * state.step_phase);
    const Eigen::Quaterniond held =
        Eigen::AngleAxisd(yaw - 0.25 * kTurn, Eigen::Vector3d::UnitZ()) *
        Eigen::AngleAxisd(nod, Eigen::Vector3d::UnitX()) *
        Eigen::AngleAxisd(roll + sway * stride, Eigen::Vector3d::UnitY());
    attitudes.push_back(held * handling.Rotation(SecondsBetween(states[0].time_ns, state.time_ns)));
  }
  return attitudes;
}

void SimulateInertial(const std::vector<WalkState>& states,
                      const std::vector<Eigen::Quaterniond>& attitudes, const Gait& gait,
                      const SimulationSettings& settings, const Handling& handling, Random* random,
                      Recording* recording) {
  const InertialSettings& sensor = settings.inertial;
  const double dt_s = SecondsBetween(states[0].time_ns, states[1].time_ns);
  const double weinberg_k =
      random->Normal(settings.gait.weinberg_k, settings.gait.weinberg_k_sigma);
  const GaitAcceleration trunk(gait, settings.gait, weinberg_k);
  Random fork = random->Fork(kAccelerationBias);
  const Eigen::Vector3d acceleration_bias = Noise(sensor.acceleration_bias_sigma_mps2, &fork);
  Eigen::Vector3d bias = Noise(sensor.gyro_bias_sigma_radps, random);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Eigen::Vector3d force =
        PathAcceleration(states, i, dt_s) + trunk.At(states, i) +
        handling.Acceleration(SecondsBetween(states[0].time_ns, states[i].time_ns)) +
        kGravityMps2 * Eigen::Vector3d::UnitZ();
    recording->accelerometer_mps2.push_back(states[i].time_ns,
                                            attitudes[i].conjugate() * force + acceleration_bias +
                                                Noise(sensor.acceleration_noise_mps2, random));
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(i + 1, states.size() - 1);
    const double span_s = dt_s * static_cast<double>(after - before);
    recording->gyroscope_radps.push_back(
        states[i].time_ns, AngularRate(attitudes[before], attitudes[after], span_s) + bias +
                               Noise(sensor.gyro_noise_radps, random));
    bias += Noise(sensor.gyro_bias_walk_radps_per_sqrt_s * std::sqrt(dt_s), random);
  }
}

}  // namespace walkgraph
