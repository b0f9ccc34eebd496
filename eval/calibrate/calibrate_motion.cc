#include "eval/calibrate/calibrate_motion.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "data/angle.h"
#include "eval/calibrate/leg_comparison.h"
#include "eval/calibrate/robust_moments.h"

namespace walkgraph {
namespace {

constexpr std::size_t kMinSamples = 10;
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

class Report {
 public:
  void Set(const std::string& key, double value, std::size_t samples, const char* basis,
           double* setting) {
    *setting = value;
    values_.push_back({"noise." + key, value, samples, basis});
  }
  std::vector<CalibratedValue> Take() { return std::move(values_); }

 private:
  std::vector<CalibratedValue> values_;
};

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
  if (along.steps.size() >= kMinSamples) {
    error = FitLegError(along);
    report->Set("step.sigma_along_m", StepSigma(error), along.steps.size(), "legs",
                &settings->step.sigma_along_m);
  }
  const Moments over_walks = MomentsOverWalks(walks, &Leg::log_scale, false, error);
  if (over_walks.samples >= kMinSamples) {
    const double mean = std::exp(over_walks.mean);
    const double spread = std::max(kSmallestScaleSpread, std::sqrt(over_walks.variance));
    report->Set("step_scale.prior_mean", mean, over_walks.samples, "walks",
                &settings->step_scale.prior_mean);
    report->Set("step_scale.prior_sigma", mean * spread, over_walks.samples, "walks",
                &settings->step_scale.prior_sigma);
  }
  if (scale.pairs >= kMinSamples) {
    report->Set("step_scale.walk_per_sqrt_s",
                std::max(kSmallestScaleWalk, std::sqrt(scale.variance_over_lag.slope)), scale.pairs,
                "pairs of legs", &settings->step_scale.walk_per_sqrt_s);
  }
}

void CalibrateOffset(const std::vector<WalkLegs>& walks, const LegStatistics& offset,
                     const LegError& error, FactorSettings* settings, Report* report) {
  const Moments over_walks = MomentsOverWalks(walks, &Leg::heading_rad, true, error);
  if (over_walks.samples >= kMinSamples) {
    const double spread = std::max(kSmallestHeadingSpread, std::sqrt(over_walks.variance));
    report->Set("heading_offset.prior_mean_rad", over_walks.mean, over_walks.samples, "walks",
                &settings->heading_offset.prior_mean_rad);
    report->Set("heading_offset.prior_sigma_rad", spread, over_walks.samples, "walks",
                &settings->heading_offset.prior_sigma_rad);
  }
  if (offset.pairs < kMinSamples) return;
  report->Set("heading_offset.walk_rad_per_sqrt_s",
              std::max(kSmallestHeadingWalk, std::sqrt(offset.variance_over_lag.slope)),
              offset.pairs, "pairs of legs", &settings->heading_offset.walk_rad_per_sqrt_s);
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

// How well legs keep their direction: on the gyroscope alone, and on the absolute heading beyond
// that.
void CalibrateDirections(const std::vector<WalkLegs>& absolute,
                         const std::vector<WalkLegs>& by_gyroscope, FactorSettings* settings,
                         Report* report) {
  constexpr double kSmallestRate = 0.01;          // a phone's gyroscope alone, rad/sqrt(s)
  constexpr double kSmallestHeadingSigma = 0.03;  // two degrees: a walking person's sway
  const LegStatistics offset = Summarise(absolute, &Leg::heading_rad, true);
  const DriftFreeDifferences turn = DifferencesWithoutDrift(by_gyroscope, &Leg::heading_rad);
  const std::vector<double> turn_parts =
      VarianceComponents(turn.difference, {turn.noise, turn.wander});
  const bool has_turn = turn.difference.size() >= kMinSamples;
  if (has_turn) {
    report->Set("heading_increment.sigma_rad_per_sqrt_s",
                std::max(kSmallestRate, std::sqrt(turn_parts[1])), turn.difference.size(),
                "pairs of legs", &settings->heading_increment.sigma_rad_per_sqrt_s);
  }
  // A walk has no mean direction on a gyroscope that drifts.
  const LegDeviations across =
      DeviationsFromNeighbours(has_turn ? by_gyroscope : absolute, &Leg::heading_rad, true);
  LegError error;
  if (across.steps.size() >= kMinSamples) {
    error = FitLegError(across);
    report->Set("step.sigma_across_m", StepSigma(error), across.steps.size(), "legs",
                &settings->step.sigma_across_m);
  }
  if (has_turn && offset.pairs >= kMinSamples) {
    const double beyond = 0.5 * offset.variance_over_lag.intercept - turn_parts[0];
    error.compass_correlation_s = settings->absolute_heading.correlation_s;
    error.compass_rad2 =
        std::max(0.0, beyond) / MeanShareLeft(absolute, error.compass_correlation_s);
    report->Set("absolute_heading.sigma_rad",
                std::max(kSmallestHeadingSigma, std::sqrt(error.compass_rad2)), offset.pairs,
                "pairs of legs", &settings->absolute_heading.sigma_rad);
  }
  CalibrateOffset(absolute, offset, error, settings, report);
}

// Drift of absolute heading against integrated yaw, rad/s; NaN for short walks. The median over
// spans of the walk, in each of which it is less than half a turn: a phone that is held upright for
// a moment has a heading that turns round and may come back by the other way, and from then on its
// unwrapped heading is whole turns off.
double DriftRate(const Evidence& evidence) {
  constexpr double kMinSeconds = 10, kLongestSpanS = 20, kIntervalS = 0.5;
  const Stream<double>& heading = evidence.absolute_heading_rad;
  const Stream<double>& yaw = evidence.gyro_yaw_rad;
  if (heading.empty() || yaw.empty()) return std::nan("");
  const TimeNs begin = std::max(heading.time_ns.front(), yaw.time_ns.front());
  const TimeNs end = std::min(heading.time_ns.back(), yaw.time_ns.back());
  const double seconds = SecondsBetween(begin, end);
  if (seconds < kMinSeconds) return std::nan("");
  const double span_s = std::min(kLongestSpanS, 0.75 * seconds);
  const auto apart = [&](TimeNs time) {
    return Interpolate(heading, time) - Interpolate(yaw, time);
  };
  std::vector<double> rates;
  for (TimeNs from = begin; from + DurationNs(span_s) <= end; from += DurationNs(kIntervalS)) {
    rates.push_back(WrapAngle(apart(from + DurationNs(span_s)) - apart(from)) / span_s);
  }
  return Median(std::move(rates));
}

void CalibrateGyroscopeBias(const std::vector<CalibrationWalk>& walks, FactorSettings* settings,
                            Report* report) {
  constexpr double kSmallestBias = 1e-4;  // below what a walk of a minute can show, rad/s
  std::vector<double> rates;
  for (const CalibrationWalk& walk : walks) {
    const double rate = DriftRate(*walk.evidence);
    if (std::isfinite(rate)) rates.push_back(rate);
  }
  if (rates.size() < kMinSamples) return;
  const Moments moments = ClippedMoments(rates);
  const double second_moment = moments.variance + moments.mean * moments.mean;
  report->Set("gyro_bias.prior_sigma_radps", std::max(kSmallestBias, std::sqrt(second_moment)),
              moments.samples, "walks", &settings->gyro_bias.prior_sigma_radps);
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
  CalibrateGyroscopeBias(walks, settings, &report);
  return report.Take();
}

}  // namespace walkgraph
