#include "frontends/sensor_figures.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include "data/angle.h"
#include "frontends/signal.h"

namespace walkgraph {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kYawSmoothingS = 1.0;  // about a stride: the phone sways with it

// A displacement in the plane: complex numbers turn and scale by one factor.
using Plane = std::complex<double>;

struct Leg {
  LegFigures figures;
  Plane true_displacement;
  Plane reckoned;  // in the frame of the heading it was made with
};

// Indices [first, last) of the samples inside [begin_ns, end_ns].
template <typename T>
std::pair<std::size_t, std::size_t> Inside(const Stream<T>& stream, TimeNs begin_ns,
                                           TimeNs end_ns) {
  const auto& t = stream.time_ns;
  const auto first = std::lower_bound(t.begin(), t.end(), begin_ns);
  const auto last = std::upper_bound(first, t.end(), end_ns);
  return {static_cast<std::size_t>(first - t.begin()), static_cast<std::size_t>(last - t.begin())};
}

bool IsStraight(const Stream<double>& smooth_yaw_rad, TimeNs begin_ns, TimeNs end_ns) {
  const auto [first, last] = Inside(smooth_yaw_rad, begin_ns, end_ns);
  if (first == last) return false;
  double sum = 0;
  for (std::size_t i = first; i < last; ++i) sum += smooth_yaw_rad.value[i];
  const double mean = sum / static_cast<double>(last - first);
  return std::all_of(smooth_yaw_rad.value.begin() + static_cast<std::ptrdiff_t>(first),
                     smooth_yaw_rad.value.begin() + static_cast<std::ptrdiff_t>(last),
                     [&](double yaw) { return std::abs(yaw - mean) <= kStraightRad; });
}

void AddSteps(const Evidence& evidence, const Stream<double>& heading_rad, Leg* leg) {
  for (const StepEvidence& step : evidence.steps) {
    const TimeNs from = std::max(step.begin_ns, leg->figures.begin_ns);
    const TimeNs to = std::min(step.end_ns, leg->figures.end_ns);
    if (from >= to) continue;
    const double share = SecondsBetween(from, to) / SecondsBetween(step.begin_ns, step.end_ns);
    leg->figures.steps += share;
    leg->figures.estimated_m += share * step.length_m;
    if (heading_rad.empty()) continue;
    const TimeNs middle = step.begin_ns + (step.end_ns - step.begin_ns) / 2;
    leg->reckoned += std::polar(share * step.length_m, Interpolate(heading_rad, middle));
  }
}

std::vector<Leg> FindLegs(const Evidence& evidence, const Truth& truth) {
  const bool by_gyroscope = !evidence.gyro_yaw_rad.empty();
  const Stream<double>& heading =
      by_gyroscope ? evidence.gyro_yaw_rad : evidence.absolute_heading_rad;
  Stream<double> smooth = heading;
  smooth.value = CenteredMean(heading.time_ns, heading.value, kYawSmoothingS);
  std::vector<Leg> legs;
  for (std::size_t i = 1; i < truth.waypoints.size(); ++i) {
    const Waypoint& from = truth.waypoints[i - 1];
    const Waypoint& to = truth.waypoints[i];
    const Eigen::Vector2d way = to.position - from.position;
    if (from.floor != to.floor || way.norm() < kMinLegM || from.time_ns >= to.time_ns) continue;
    Leg leg;
    leg.figures.begin_ns = from.time_ns;
    leg.figures.end_ns = to.time_ns;
    leg.figures.true_m = way.norm();
    leg.figures.straight = by_gyroscope && IsStraight(smooth, from.time_ns, to.time_ns);
    leg.true_displacement = {way.x(), way.y()};
    AddSteps(evidence, heading, &leg);
    legs.push_back(leg);
  }
  return legs;
}

void SetDisplacementErrors(std::vector<Leg>* legs) {
  Plane product = 0;
  double energy = 0;
  for (const Leg& leg : *legs) {
    product += std::conj(leg.reckoned) * leg.true_displacement;
    energy += std::norm(leg.reckoned);
  }
  const bool possible = legs->size() >= 2 && energy > 0;
  const Plane best = possible ? product / energy : Plane(kNaN, kNaN);
  for (Leg& leg : *legs) {
    leg.figures.displacement_error =
        std::abs(best * leg.reckoned - leg.true_displacement) / leg.figures.true_m;
  }
}

void AddHeadingErrors(const Evidence& evidence, const Leg& leg, double heading_to_building_rad,
                      SensorFigures* figures) {
  const Stream<double>& heading = evidence.absolute_heading_rad;
  const auto [first, last] = Inside(heading, leg.figures.begin_ns, leg.figures.end_ns);
  const double direction = std::arg(leg.true_displacement) - heading_to_building_rad;
  auto motion = evidence.motion.begin();
  for (std::size_t i = first; i < last; ++i) {
    while (motion != evidence.motion.end() && motion->end_ns <= heading.time_ns[i]) ++motion;
    if (motion == evidence.motion.end()) return;
    const double error = WrapAngle(direction - heading.value[i]);
    if (motion->state == MotionState::kWalking) figures->heading_walking.Add(error);
    if (motion->state == MotionState::kStanding) figures->heading_standing.Add(error);
  }
}

double Mean(const std::vector<double>& values) {
  if (values.empty()) return kNaN;
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// Nearest-rank quantile.
double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return kNaN;
  const auto rank = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank),
                   values.end());
  return values[rank];
}

}  // namespace

void HeadingFigures::Add(double error_rad) {
  ++samples;
  sum_rad += error_rad;
  sum_squared_rad2 += error_rad * error_rad;
}

void HeadingFigures::Add(const HeadingFigures& other) {
  samples += other.samples;
  sum_rad += other.sum_rad;
  sum_squared_rad2 += other.sum_squared_rad2;
}

double HeadingFigures::MeanRad() const {
  return samples > 0 ? sum_rad / static_cast<double>(samples) : 0.0;
}

double HeadingFigures::RmsRad() const {
  return samples > 0 ? std::sqrt(sum_squared_rad2 / static_cast<double>(samples)) : 0.0;
}

SensorFigures ComputeSensorFigures(const Evidence& evidence, const Truth& truth,
                                   double heading_to_building_rad) {
  if (truth.frame != TruthFrame::kBuilding && !truth.waypoints.empty()) {
    throw std::invalid_argument("ComputeSensorFigures: truth is not in the building frame");
  }
  SensorFigures figures;
  std::vector<Leg> legs = FindLegs(evidence, truth);
  SetDisplacementErrors(&legs);
  for (const Leg& leg : legs) {
    figures.legs.push_back(leg.figures);
    if (leg.figures.straight) AddHeadingErrors(evidence, leg, heading_to_building_rad, &figures);
  }
  return figures;
}

SensorSummary Summarize(const std::vector<SensorFigures>& walks) {
  SensorSummary summary;
  std::vector<double> rates;
  std::vector<double> errors;
  for (const SensorFigures& walk : walks) {
    ++summary.walks;
    summary.heading_walking.Add(walk.heading_walking);
    summary.heading_standing.Add(walk.heading_standing);
    for (const LegFigures& leg : walk.legs) {
      ++summary.legs;
      summary.straight_legs += leg.straight;
      if (leg.straight) rates.push_back(leg.DistanceRate());
      if (std::isfinite(leg.displacement_error)) errors.push_back(leg.displacement_error);
    }
  }
  summary.distance_rate_mean = Mean(rates);
  summary.distance_rate_median = Quantile(rates, 0.5);
  std::vector<double> squares = rates;
  for (double& rate : squares)
    rate = (rate - summary.distance_rate_mean) * (rate - summary.distance_rate_mean);
  summary.distance_rate_std = std::sqrt(Mean(squares));
  summary.displacement_error_median = Quantile(errors, 0.5);
  summary.displacement_error_p90 = Quantile(errors, 0.9);
  return summary;
}

}  // namespace walkgraph
