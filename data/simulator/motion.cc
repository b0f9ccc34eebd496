#include "data/simulator/motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "data/angle.h"

namespace walkgraph {
namespace {

constexpr double kSpeedTimeConstantS = 0.35;  // gait starts and stops within one or two steps
constexpr double kStandingSpeedMps = 0.02;    // slower than this the feet rest
constexpr double kTurnS = 2.0;                // a half turn on the spot
constexpr double kGapM = 1.0;  // where paths join, what is left between them is walked off

// From 0 to 1 with zero speed at both ends.
double EaseInOut(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * t * (10.0 + t * (6.0 * t - 15.0));
}

class Walker {
 public:
  Walker(const Gait& gait, const SimulationSettings& settings, TimeNs begin_ns, TimeNs interval_ns,
         Random* random)
      : gait_(gait),
        settings_(settings),
        interval_ns_(interval_ns),
        dt_s_(SecondsBetween(0, interval_ns)),
        random_(random),
        this_step_m_(gait.step_length_m) {
    state_.time_ns = begin_ns;
  }

  // `next` is null behind the last leg.
  void WalkLeg(const Leg& leg, const Leg* next, double wait_s);
  std::vector<WalkState> TakeStates() { return std::move(states_); }

 private:
  void Begin(const Leg& leg, double wait_s);
  void Place(const Leg& leg);
  void PlaceAtEnd(const Leg& leg);
  void Decide(const Leg& leg, const Leg* next);
  void Move(const Route& route);
  double TargetSpeed(WayKind kind, bool up) const;
  Activity ActivityOn(WayKind kind) const;

  Gait gait_;
  const SimulationSettings& settings_;
  TimeNs interval_ns_;
  double dt_s_;
  Random* random_;
  std::vector<WalkState> states_;
  WalkState state_;
  double this_step_m_;
  double step_ratio_ = 1.0;  // of the step in use to the one that would be taken on a floor
  // Of the present leg:
  double leg_begin_m_ = 0;
  double along_m_ = 0;
  Eigen::Vector2d gap_m_ = Eigen::Vector2d::Zero();
  std::size_t next_stop_ = 0;
  double standing_s_ = 0;
  bool arrived_ = false;
  double since_arrival_s_ = 0;
  double turn_on_spot_rad_ = 0;
};

void Walker::Begin(const Leg& leg, double wait_s) {
  if (states_.empty()) {
    state_.heading_rad = leg.route.HeadingAt(0);
  } else {
    state_.time_ns += interval_ns_;
    gap_m_ = state_.position_m - leg.route.At(0);
  }
  leg_begin_m_ = state_.distance_m;
  along_m_ = 0;
  next_stop_ = 0;
  standing_s_ = wait_s;
  arrived_ = false;
  since_arrival_s_ = 0;
}

void Walker::Place(const Leg& leg) {
  state_.distance_m = leg_begin_m_ + along_m_;
  state_.position_m = leg.route.At(along_m_) + std::exp(-along_m_ / kGapM) * gap_m_;
  state_.height_m = leg.route.HeightAt(along_m_);
  const double turn_on_spot =
      turn_on_spot_rad_ * EaseInOut((since_arrival_s_ - kStandAtEndsS) / kTurnS);
  const double heading = leg.route.HeadingAt(along_m_) + (arrived_ ? turn_on_spot : 0.0);
  const double turn = WrapAngle(heading - state_.heading_rad);
  state_.heading_rad += turn;
  state_.activity = ActivityOn(leg.route.KindAt(along_m_));
  if (arrived_ && leg.lift_rise_m != 0.0) PlaceAtEnd(leg);
}

// In the cabin: doors close, the lift rides, doors open.
void Walker::PlaceAtEnd(const Leg& leg) {
  const LiftRide ride(leg.lift_rise_m, settings_.ride);
  const double riding_s = since_arrival_s_ - kStandAtEndsS - kTurnS - settings_.ride.door_s;
  state_.height_m += ride.HeightAt(riding_s);
  if (riding_s > 0.0 && riding_s < ride.duration_s()) state_.activity = Activity::kLift;
}

Activity Walker::ActivityOn(WayKind kind) const {
  if (kind == WayKind::kEscalator && along_m_ > 0) return Activity::kEscalator;
  if (state_.speed_mps == 0.0) return Activity::kStand;
  return kind == WayKind::kStairs ? Activity::kStairs : Activity::kWalk;
}

void Walker::Decide(const Leg& leg, const Leg* next) {
  // The distance in which the low-pass filter brings the person to rest.
  const double braking_m = state_.speed_mps * kSpeedTimeConstantS;
  if (next_stop_ < leg.stops.size() && along_m_ + braking_m >= leg.stops[next_stop_].distance_m) {
    standing_s_ = leg.stops[next_stop_++].duration_s;
  }
  if (!arrived_ && along_m_ + braking_m >= leg.route.length_m()) {
    arrived_ = true;
    standing_s_ = kStandAtEndsS;
    turn_on_spot_rad_ = 0;
    if (next != nullptr) {
      standing_s_ += kTurnS;
      turn_on_spot_rad_ =
          WrapAngle(next->route.HeadingAt(0) - leg.route.HeadingAt(leg.route.length_m()));
    }
    if (leg.lift_rise_m != 0.0) {
      standing_s_ +=
          2.0 * settings_.ride.door_s + LiftRide(leg.lift_rise_m, settings_.ride).duration_s();
    }
  }
  standing_s_ = std::max(0.0, standing_s_ - dt_s_);
}

double Walker::TargetSpeed(WayKind kind, bool up) const {
  const GaitSettings& gait = settings_.gait;
  if (kind == WayKind::kStairs) {
    return gait.tread_m * (up ? gait.stairs_up_rate_hz : gait.stairs_down_rate_hz);
  }
  if (kind == WayKind::kEscalator) {
    const RideSettings& ride = settings_.ride;
    return ride.escalator_speed_mps * std::cos(DegreesToRadians(ride.escalator_slope_deg));
  }
  return gait_.step_rate_hz * this_step_m_;
}

void Walker::Move(const Route& route) {
  const WayKind kind = route.KindAt(along_m_);
  const bool up = route.HeightAt(along_m_ + 1.0) >= route.HeightAt(along_m_);
  const double target_mps = standing_s_ > 0.0 ? 0.0 : TargetSpeed(kind, up);
  const double change = 1.0 - std::exp(-dt_s_ / kSpeedTimeConstantS);
  state_.speed_mps += (target_mps - state_.speed_mps) * change;
  if (target_mps == 0.0 && state_.speed_mps < kStandingSpeedMps) state_.speed_mps = 0.0;
  const double ratio = kind == WayKind::kStairs ? settings_.gait.tread_m / this_step_m_ : 1.0;
  step_ratio_ += (ratio - step_ratio_) * change;
  if (kind != WayKind::kEscalator) {
    const double before = std::floor(state_.step_phase);
    state_.step_phase += state_.speed_mps / (this_step_m_ * step_ratio_) * dt_s_;
    if (std::floor(state_.step_phase) > before) {
      this_step_m_ = random_->Normal(gait_.step_length_m, gait_.step_length_sigma_m);
    }
  }
  along_m_ += state_.speed_mps * dt_s_;
  if (arrived_) since_arrival_s_ += dt_s_;
  state_.time_ns += interval_ns_;
}

void Walker::WalkLeg(const Leg& leg, const Leg* next, double wait_s) {
  Begin(leg, wait_s);
  while (true) {
    Place(leg);
    states_.push_back(state_);
    Decide(leg, next);
    if (arrived_ && standing_s_ == 0.0) return;
    Move(leg.route);
  }
}

// Means of `get(state)` over a window of 2 half + 1 states, the first and last one repeated
// outside.
template <typename Value, typename Get>
std::vector<Value> MovingMeans(const std::vector<WalkState>& states, std::ptrdiff_t half,
                               const Get& get) {
  const auto count = static_cast<std::ptrdiff_t>(states.size());
  const auto at = [&](std::ptrdiff_t i) -> Value {
    return get(states[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, count - 1))]);
  };
  // Sums of differences from the first value lose no digits on long walks.
  const Value first = at(0);
  Value sum = first - first;
  for (std::ptrdiff_t i = -half; i <= half; ++i) sum += at(i) - first;
  std::vector<Value> means;
  means.reserve(states.size());
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    means.push_back(first + sum / static_cast<double>(2 * half + 1));
    sum += at(i + half + 1) - at(i - half);
  }
  return means;
}

void SmoothOnce(std::ptrdiff_t half, std::vector<WalkState>* states) {
  const auto place = [](const WalkState& state) {
    return Eigen::Vector4d(state.position_m.x(), state.position_m.y(), state.height_m,
                           state.heading_rad);
  };
  const std::vector<Eigen::Vector4d> means = MovingMeans<Eigen::Vector4d>(*states, half, place);
  for (std::size_t i = 0; i < states->size(); ++i) {
    (*states)[i].position_m = means[i].head<2>();
    (*states)[i].height_m = means[i].z();
    (*states)[i].heading_rad = means[i].w();
  }
}

}  // namespace

Gait RandomGait(const GaitSettings& settings, Random* random) {
  Gait gait;
  gait.step_rate_hz = random->Normal(settings.step_rate_hz, settings.step_rate_sigma_hz);
  gait.step_length_m = random->Normal(settings.step_length_m, settings.step_length_sigma_m);
  gait.step_length_sigma_m = settings.step_variation * gait.step_length_m;
  return gait;
}

LiftRide::LiftRide(double rise_m, const RideSettings& settings) : rise_m_(rise_m) {
  constexpr double kPi = std::numbers::pi;
  // A ramp to speed v with the largest acceleration a takes pi v/(2 a), and both ramps together
  // the height v times that; short rides do not reach the full speed.
  const double rise = std::abs(rise_m);
  const double reached = std::sqrt(2.0 * settings.lift_acceleration_mps2 * rise / kPi);
  const double speed = std::min(settings.lift_speed_mps, reached);
  ramp_s_ = kPi * speed / (2.0 * settings.lift_acceleration_mps2);
  cruise_s_ = speed > 0.0 ? std::max(0.0, rise / speed - ramp_s_) : 0.0;
  speed_mps_ = std::copysign(speed, rise_m);
}

double LiftRide::RampHeight(double time_s) const {
  const double phase = std::numbers::pi * time_s / ramp_s_;
  return 0.5 * speed_mps_ * (time_s - ramp_s_ / std::numbers::pi * std::sin(phase));
}

double LiftRide::HeightAt(double time_s) const {
  if (time_s <= 0.0) return 0.0;
  if (time_s >= duration_s()) return rise_m_;
  if (time_s < ramp_s_) return RampHeight(time_s);
  if (time_s < ramp_s_ + cruise_s_) {
    return 0.5 * speed_mps_ * ramp_s_ + speed_mps_ * (time_s - ramp_s_);
  }
  return rise_m_ - RampHeight(duration_s() - time_s);
}

void SmoothPath(double window_s, std::vector<WalkState>* states) {
  const double dt_s = SecondsBetween((*states)[0].time_ns, (*states)[1].time_ns);
  const auto half = static_cast<std::ptrdiff_t>(std::lround(0.5 * window_s / dt_s));
  SmoothOnce(half, states);
  SmoothOnce(half, states);
}

std::vector<WalkState> WalkLegs(const std::vector<Leg>& legs, const Gait& gait,
                                const SimulationSettings& settings, double wait_s, TimeNs begin_ns,
                                TimeNs interval_ns, Random* random) {
  Walker walker(gait, settings, begin_ns, interval_ns, random);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    walker.WalkLeg(legs[i], i + 1 < legs.size() ? &legs[i + 1] : nullptr, i == 0 ? wait_s : 0.0);
  }
  return walker.TakeStates();
}

}  // namespace walkgraph
