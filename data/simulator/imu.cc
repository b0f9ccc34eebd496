#include "data/simulator/imu.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "data/angle.h"

namespace walkgraph {
namespace {

constexpr double kGravityMps2 = 9.80665;
constexpr double kTurn = 2.0 * std::numbers::pi;

// Weinberg (AN-602, 2002): step length = K * swing^(1/4), here read backwards to get the vertical
// swing of a step. K differs by a few percent between persons, which is what a step-scale state is
// for.
constexpr double kWeinbergK = 0.42;
constexpr double kWeinbergKSigma = 0.02;
// Forward and sideways acceleration of the trunk against the vertical one (Zijlstra and Hof, Gait
// and Posture 18, 2003): forward about half, with the steps; sideways a quarter, with the strides.
constexpr double kForwardShare = 0.5;
constexpr double kSidewaysShare = 0.25;
constexpr double kSecondHarmonicShare = 0.2;

// A hand that follows the body: nods with the steps, sways with the strides.
constexpr double kPitchRad = DegreesToRadians(25.0);
constexpr double kPitchSigmaRad = DegreesToRadians(6.0);
constexpr double kRollSigmaRad = DegreesToRadians(4.0);
constexpr double kSwayRad = DegreesToRadians(2.0);
// How far the phone points past the direction of walking, and the hand's slow wandering around it.
constexpr double kHoldSigmaRad = DegreesToRadians(6.0);
constexpr double kHandWanderRad = DegreesToRadians(2.0);
constexpr double kHandWanderS = 5.0;

// Bosch BMI160 data sheet: noise 180 ug/rtHz and 0.007 deg/s/rtHz over 20 Hz; what zero-rate offset
// is left after the phone's own calibration (Android's compatibility definition asks for no value;
// some 0.3 deg/s is usual) and its random walk.
constexpr double kAccelerationNoiseMps2 = 0.008;
constexpr double kAngularRateNoiseRadps = DegreesToRadians(0.03);
constexpr double kGyroBiasSigmaRadps = DegreesToRadians(0.3);
constexpr double kGyroBiasWalkRadpsPerRootS = DegreesToRadians(0.01);
// A rotation vector's yaw: the magnetic error that a walk keeps, and the one that changes along the
// way as steel goes by (Afzal, Renaudin and Lachapelle, Int. J. Navigation Observation, 2011:
// indoor perturbations last metres to tens of metres and turn headings by up to tens of degrees).
constexpr double kYawOffsetSigmaRad = DegreesToRadians(7.0);
constexpr double kYawWanderRad = DegreesToRadians(6.0);
constexpr double kYawWanderS = 8.0;
// Earth's field in central Europe (World Magnetic Model 2020): 20 uT north, 45 uT down. AK09911
// noise.
constexpr double kHorizontalFieldUt = 20.0;
constexpr double kVerticalFieldUt = 45.0;
constexpr double kMagneticNoiseUt = 0.5;
// BMP280 in the forced modes of phones: 0.2 Pa at best, 1.5 Pa seen; weather and the sensor's own
// offset.
constexpr double kPressureHpa = 1005.0;
constexpr double kPressureSigmaHpa = 3.0;
constexpr double kPressureNoiseHpa = 0.015;

constexpr std::size_t kSlowEvery = 10;  // rotation vector and magnetometer against the IMU

// A Gauss-Markov process (first order) that is started in its stationary distribution.
class Wander {
 public:
  Wander(double sigma, double time_constant_s, double dt_s, Random* random)
      : sigma_(sigma), keep_(std::exp(-dt_s / time_constant_s)), value_(random->Normal(0, sigma)) {}

  double Next(Random* random) {
    value_ = keep_ * value_ + sigma_ * std::sqrt(1.0 - keep_ * keep_) * random->Normal();
    return value_;
  }

 private:
  double sigma_;
  double keep_;
  double value_;
};

Eigen::Vector3d Noise(double sigma, Random* random) {
  const double x = random->Normal();
  const double y = random->Normal();
  const double z = random->Normal();
  return sigma * Eigen::Vector3d(x, y, z);
}

// How strongly the person walks at this moment: 0 standing, 1 at the usual speed.
double Effort(const WalkState& state, const Gait& gait) {
  return std::min(1.2, state.speed_mps / (gait.step_rate_hz * gait.step_length_m));
}

// Attitudes of the phone, device to building axes (x east, y north, z up); device y points forward.
std::vector<Eigen::Quaterniond> Attitudes(const std::vector<WalkState>& states, const Gait& gait,
                                          double dt_s, Random* random) {
  const double hold = random->Normal(0.0, kHoldSigmaRad);
  const double pitch = random->Normal(kPitchRad, kPitchSigmaRad);
  const double roll = random->Normal(0.0, kRollSigmaRad);
  Wander hand(kHandWanderRad, kHandWanderS, dt_s, random);
  // A hand has mass: what it wanders is smoothed to below the frequency of the steps.
  double smooth_hand = 0;
  const double smoothing = 1.0 - std::exp(-dt_s / 0.5);
  std::vector<Eigen::Quaterniond> attitudes;
  attitudes.reserve(states.size());
  for (const WalkState& state : states) {
    const double effort = Effort(state, gait);
    smooth_hand += smoothing * (hand.Next(random) - smooth_hand);
    const double stride = std::sin(0.5 * kTurn * state.step_phase);
    const double yaw = state.heading_rad + hold + smooth_hand + effort * kSwayRad * stride;
    const double nod = pitch + effort * kSwayRad * std::cos(kTurn * state.step_phase);
    attitudes.push_back(
        Eigen::AngleAxisd(yaw - 0.25 * kTurn, Eigen::Vector3d::UnitZ()) *
        Eigen::AngleAxisd(nod, Eigen::Vector3d::UnitX()) *
        Eigen::AngleAxisd(roll + effort * kSwayRad * stride, Eigen::Vector3d::UnitY()));
  }
  return attitudes;
}

// Acceleration of the phone in building axes: of the path, and of the gait around it.
Eigen::Vector3d Acceleration(const std::vector<WalkState>& states, std::size_t i, const Gait& gait,
                             double weinberg_k, double dt_s) {
  const WalkState& state = states[i];
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  if (i > 0 && i + 1 < states.size()) {
    acceleration.head<2>() =
        (states[i + 1].position_m - 2.0 * state.position_m + states[i - 1].position_m) /
        (dt_s * dt_s);
  }
  const double swing = std::pow(gait.step_length_m / weinberg_k, 4.0);
  const double amplitude = 0.5 * swing * Effort(state, gait);
  const double phase = kTurn * state.step_phase;
  const Eigen::Vector2d forward(std::cos(state.heading_rad), std::sin(state.heading_rad));
  const Eigen::Vector2d left(-forward.y(), forward.x());
  acceleration.head<2>() += kForwardShare * amplitude * std::sin(phase) * forward +
                            kSidewaysShare * amplitude * std::sin(0.5 * phase) * left;
  acceleration.z() = amplitude * (std::cos(phase) + kSecondHarmonicShare * std::sin(2.0 * phase));
  return acceleration;
}

// Mean angular rate from one attitude to another, axes of the first.
Eigen::Vector3d AngularRate(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to,
                            double dt_s) {
  const Eigen::AngleAxisd turn(from.conjugate() * to);
  const double angle = WrapAngle(turn.angle());
  return turn.axis() * (angle / dt_s);
}

void SimulateInertial(const std::vector<WalkState>& states,
                      const std::vector<Eigen::Quaterniond>& attitudes, const Gait& gait,
                      double dt_s, Random* random, Recording* recording) {
  const double weinberg_k = random->Normal(kWeinbergK, kWeinbergKSigma);
  Eigen::Vector3d bias = Noise(kGyroBiasSigmaRadps, random);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Eigen::Vector3d force =
        Acceleration(states, i, gait, weinberg_k, dt_s) + kGravityMps2 * Eigen::Vector3d::UnitZ();
    recording->accelerometer_mps2.push_back(
        states[i].time_ns,
        attitudes[i].conjugate() * force + Noise(kAccelerationNoiseMps2, random));
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(i + 1, states.size() - 1);
    const double span_s = dt_s * static_cast<double>(after - before);
    recording->gyroscope_radps.push_back(
        states[i].time_ns, AngularRate(attitudes[before], attitudes[after], span_s) + bias +
                               Noise(kAngularRateNoiseRadps, random));
    bias += Noise(kGyroBiasWalkRadpsPerRootS * std::sqrt(dt_s), random);
  }
}

void SimulateMagnetic(const std::vector<WalkState>& states,
                      const std::vector<Eigen::Quaterniond>& attitudes, double dt_s, Random* random,
                      Recording* recording) {
  const double offset = random->Normal(0.0, kYawOffsetSigmaRad);
  Wander wander(kYawWanderRad, kYawWanderS, dt_s * kSlowEvery, random);
  const Eigen::Vector3d field(0.0, kHorizontalFieldUt, -kVerticalFieldUt);
  for (std::size_t i = 0; i < states.size(); i += kSlowEvery) {
    // North seems turned by the error, and everything that looks north with it.
    const double error = offset + wander.Next(random);
    const Eigen::Quaterniond to_seeming_north(Eigen::AngleAxisd(error, Eigen::Vector3d::UnitZ()));
    Eigen::Quaterniond seen = to_seeming_north * attitudes[i];
    if (seen.w() < 0) seen.coeffs() = -seen.coeffs();
    recording->rotation_vector.push_back(states[i].time_ns, seen);
    recording->magnetometer_ut.push_back(
        states[i].time_ns, seen.conjugate() * field + Noise(kMagneticNoiseUt, random));
  }
}

}  // namespace

void SimulateImu(const std::vector<WalkState>& states, const Gait& gait, Random* random,
                 Recording* recording) {
  const double dt_s = SecondsBetween(states[0].time_ns, states[1].time_ns);
  const std::vector<Eigen::Quaterniond> attitudes = Attitudes(states, gait, dt_s, random);
  SimulateInertial(states, attitudes, gait, dt_s, random, recording);
  SimulateMagnetic(states, attitudes, dt_s, random, recording);
  const double pressure_hpa = random->Normal(kPressureHpa, kPressureSigmaHpa);
  const auto per_second = static_cast<std::size_t>(std::lround(1.0 / dt_s));
  for (std::size_t i = 0; i < states.size(); i += per_second) {
    recording->pressure_hpa.push_back(states[i].time_ns,
                                      random->Normal(pressure_hpa, kPressureNoiseHpa));
  }
}

}  // namespace walkgraph
