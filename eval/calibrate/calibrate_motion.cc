#include "eval/calibrate/calibrate_motion.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <utility>

#include "data/angle.h"
#include "eval/calibrate/leg_comparison.h"
#include "eval/calibrate/robust_moments.h"
#include "eval/calibrate/sensor_noise.h"

namespace walkgraph {
namespace {

// A random walk that walks of a minute cannot tell from none: 1 degree, and 1 %, in half a minute.
constexpr double kSmallestHeadingWalk = 0.003;  // rad/sqrt(s)
constexpr double kSmallestScaleWalk = 0.002;    // 1/sqrt(s)
// No survey tells people, or how they hold their phones, apart by less.
constexpr double kSmallestHeadingSpread = 0.02;
constexpr double kSmallestScaleSpread = 0.01;

// Dead reckoning with all slow states at zero, so that what is learnt is absolute.
DeadReckonedPath PlainPath(const Building& building, const Evidence& evidence) {
  Site site;
  site.building.origin = building.origin;
  FactorSettings plain;
  plain.heading_offset.mode = StateMode::kAbsent;
  plain.step_scale.mode = StateMode::kAbsent;
  return DeadReckon(site, evidence, plain);
}

// The error of one step, from how the legs' errors grow with their steps: what they do not grow
// with belongs to the waypoints. Where the legs' value wanders, that grows faster.
LegError FitLegError(const LegDeviations& deviations) {
  std::vector<std::vector<double>> columns = {std::vector<double>(deviations.steps.size(), 1.0),
                                              deviations.steps};
  if (!deviations.wander.empty()) columns.push_back(deviations.wander);
  const std::vector<double> parts = VarianceComponents(deviations.deviation_m, columns);
  return {parts[0], parts[1]};
}

double StepSigma(const LegError& error) {
  constexpr double kSmallestM = 0.05;  // sway of the body and timing of the step
  return std::max(kSmallestM, std::sqrt(error.step_m2));
}

using Report = std::vector<CalibratedValue>;

struct LegStatistics {
  Line variance_over_lag;  // of differences between a walk's legs
  std::size_t pairs = 0;
};

LegStatistics Summarise(const std::vector<WalkLegs>& walks, double Leg::*value, bool circular) {
  const PairDifferences pairs = DifferencesWithinWalks(walks, value, circular);
  return {VarianceOverLag(pairs.difference, pairs.lag_s), pairs.difference.size()};
}

// What walks differ by. The means that they show spread further, for legs have errors.
Moments MomentsOverWalks(const std::vector<WalkLegs>& walks, double Leg::*value, bool circular,
                         const LegError& error) {
  std::vector<double> means, variances;
  for (const WalkLegs& legs : walks) {
    means.push_back(WalkMean(legs, value, circular));
    variances.push_back(VarianceOfWalkMean(legs, error));
  }
  if (!circular) return RandomEffects(means, variances);
  // Angles lie about one direction, which may be that of the seam.
  std::complex<double> sum = 0;
  for (const double mean : means) sum += std::polar(1.0, mean);
  const double direction = std::arg(sum);
  for (double& mean : means) mean = WrapAngle(mean - direction);
  Moments moments = RandomEffects(means, variances);
  moments.mean = WrapAngle(moments.mean + direction);
  return moments;
}

void CalibrateSteps(const std::vector<WalkLegs>& walks, FactorSettings* settings, Report* report) {
  const LegStatistics scale = Summarise(walks, &Leg::log_scale, false);
  const LegDeviations along = DeviationsFromWalk(walks, &Leg::log_scale, false);
  LegError error;
  if (along.steps.size() >= kMinCalibrationSamples) {
    error = FitLegError(along);
    SetCalibrated("step.sigma_along_m", StepSigma(error), along.steps.size(), "legs",
                  &settings->step.sigma_along_m, report);
  }
  const Moments over_walks = MomentsOverWalks(walks, &Leg::log_scale, false, error);
  if (over_walks.samples >= kMinCalibrationSamples) {
    const double mean = std::exp(over_walks.mean);
    const double spread = std::max(kSmallestScaleSpread, std::sqrt(over_walks.variance));
    SetCalibrated("step_scale.prior_mean", mean, over_walks.samples, "walks",
                  &settings->step_scale.prior_mean, report);
    SetCalibrated("step_scale.prior_sigma", mean * spread, over_walks.samples, "walks",
                  &settings->step_scale.prior_sigma, report);
  }
  if (scale.pairs >= kMinCalibrationSamples) {
    SetCalibrated("step_scale.walk_per_sqrt_s",
                  std::max(kSmallestScaleWalk, std::sqrt(scale.variance_over_lag.slope)),
                  scale.pairs, "pairs of legs", &settings->step_scale.walk_per_sqrt_s, report);
  }
}

void CalibrateOffset(const std::vector<WalkLegs>& walks, const LegStatistics& offset,
                     const LegError& error, FactorSettings* settings, Report* report) {
  const Moments over_walks = MomentsOverWalks(walks, &Leg::heading_rad, true, error);
  if (over_walks.samples >= kMinCalibrationSamples) {
    const double spread = std::max(kSmallestHeadingSpread, std::sqrt(over_walks.variance));
    SetCalibrated("heading_offset.prior_mean_rad", over_walks.mean, over_walks.samples, "walks",
                  &settings->heading_offset.prior_mean_rad, report);
    SetCalibrated("heading_offset.prior_sigma_rad", spread, over_walks.samples, "walks",
                  &settings->heading_offset.prior_sigma_rad, report);
  }
  if (offset.pairs < kMinCalibrationSamples) return;
  SetCalibrated("heading_offset.walk_rad_per_sqrt_s",
                std::max(kSmallestHeadingWalk, std::sqrt(offset.variance_over_lag.slope)),
                offset.pairs, "pairs of legs", &settings->heading_offset.walk_rad_per_sqrt_s,
                report);
}

// Mean over all legs of what averaging over a leg leaves of a variance that is drawn anew after
// `correlation_s`.
double MeanShareLeft(const std::vector<WalkLegs>& walks, double correlation_s) {
  double sum = 0, legs = 0;
  for (const WalkLegs& walk : walks) {
    for (const Leg& leg : walk) sum += ShareLeft(leg, correlation_s);
    legs += static_cast<double>(walk.size());
  }
  return sum / legs;
}

// How well legs keep their direction on the gyroscope alone. Returns the variance of one leg's own
// direction, nothing where too few legs bear on it.
std::optional<double> CalibrateTurns(const std::vector<WalkLegs>& by_gyroscope,
                                     FactorSettings* settings, Report* report) {
  constexpr double kSmallestRate = 0.01;      // a phone's gyroscope alone, rad/sqrt(s)
  constexpr double kSmallestBiasWalk = 5e-5;  // bias instability of a phone's, rad/s/sqrt(s)
  const DriftFreeDifferences turn = DifferencesWithoutDrift(by_gyroscope, &Leg::heading_rad);
  if (turn.difference.size() < kMinCalibrationSamples) return std::nullopt;
  const bool has_long_walks = turn.long_walks >= kMinCalibrationSamples;
  std::vector<std::vector<double>> columns = {turn.noise, turn.wander};
  if (has_long_walks) columns.push_back(turn.bias);
  const std::vector<double> parts = RelativeVarianceComponents(turn.difference, columns);
  SetCalibrated("heading_increment.sigma_rad_per_sqrt_s",
                std::max(kSmallestRate, std::sqrt(parts[1])), turn.difference.size(),
                "pairs of legs", &settings->heading_increment.sigma_rad_per_sqrt_s, report);
  // Zero only says that these walks cannot tell: their legs' own errors hide a bias that wanders.
  if (has_long_walks && parts[2] > 0) {
    SetCalibrated("gyro_bias.walk_radps_per_sqrt_s",
                  std::max(kSmallestBiasWalk, std::sqrt(parts[2])), turn.difference.size(),
                  "pairs of legs", &settings->gyro_bias.walk_radps_per_sqrt_s, report);
  }
  return parts[0];
}

// The same, and on the absolute heading beyond that.
void CalibrateDirections(const std::vector<WalkLegs>& absolute,
                         const std::vector<WalkLegs>& by_gyroscope, FactorSettings* settings,
                         Report* report) {
  constexpr double kSmallestHeadingSigma = 0.03;  // two degrees: a walking person's sway
  const LegStatistics offset = Summarise(absolute, &Leg::heading_rad, true);
  const std::optional<double> turn_rad2 = CalibrateTurns(by_gyroscope, settings, report);
  // A walk has no mean direction on a gyroscope that drifts.
  const LegDeviations across =
      DeviationsFromNeighbours(turn_rad2 ? by_gyroscope : absolute, &Leg::heading_rad, true);
  LegError error;
  if (across.steps.size() >= kMinCalibrationSamples) {
    error = FitLegError(across);
    SetCalibrated("step.sigma_across_m", StepSigma(error), across.steps.size(), "legs",
                  &settings->step.sigma_across_m, report);
  }
  if (turn_rad2 && offset.pairs >= kMinCalibrationSamples) {
    const double beyond = 0.5 * offset.variance_over_lag.intercept - *turn_rad2;
    error.compass_correlation_s = settings->absolute_heading.correlation_s;
    error.compass_rad2 =
        std::max(0.0, beyond) / MeanShareLeft(absolute, error.compass_correlation_s);
    SetCalibrated("absolute_heading.sigma_rad",
                  std::max(kSmallestHeadingSigma, std::sqrt(error.compass_rad2)), offset.pairs,
                  "pairs of legs", &settings->absolute_heading.sigma_rad, report);
  }
  CalibrateOffset(absolute, offset, error, settings, report);
}

}  // namespace

std::vector<CalibratedValue> CalibrateMotion(const Building& building,
                                             const std::vector<CalibrationWalk>& walks,
                                             FactorSettings* settings) {
  Report report;
  std::vector<WalkLegs> absolute, by_gyroscope;
  for (const CalibrationWalk& walk : walks) {
    WalkLegs legs = CompareLegs(*walk.evidence, *walk.truth, PlainPath(building, *walk.evidence));
    if (!walk.evidence->absolute_heading_rad.empty() && !legs.empty()) {
      absolute.push_back(std::move(legs));
    }
    if (walk.evidence->gyro_yaw_rad.empty()) continue;
    Evidence blind;
    blind.begin_ns = walk.evidence->begin_ns;
    blind.end_ns = walk.evidence->end_ns;
    blind.steps = walk.evidence->steps;
    blind.gyro_yaw_rad = walk.evidence->gyro_yaw_rad;
    legs = CompareLegs(blind, *walk.truth, PlainPath(building, blind));
    if (!legs.empty()) by_gyroscope.push_back(std::move(legs));
  }
  CalibrateSteps(absolute.empty() ? by_gyroscope : absolute, settings, &report);
  CalibrateDirections(absolute, by_gyroscope, settings, &report);
  CalibrateGyroscopeBias(walks, &settings->gyro_bias, &report);
  CalibrateBarometer(walks, &settings->barometric, &settings->barometric_offset, &report);
  return report;
}

}  // namespace walkgraph
