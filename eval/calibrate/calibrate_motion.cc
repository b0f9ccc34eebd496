#include "eval/calibrate/calibrate_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "eval/calibrate/leg_comparison.h"
#include "eval/calibrate/robust_moments.h"

namespace walkgraph {
namespace {

constexpr std::size_t kMinSamples = 10;

// Dead reckoning with all slow states at zero, so that what is learnt is absolute.
DeadReckonedPath PlainPath(const Building& building, const Evidence& evidence) {
  Site site;
  site.building.origin = building.origin;
  FactorSettings plain;
  plain.heading_offset.mode = StateMode::kAbsent;
  plain.step_scale.mode = StateMode::kAbsent;
  return DeadReckon(site, evidence, plain);
}

// The legs' variance (rad^2 or relative), beyond what the waypoints explain, for each of their
// steps in metres.
double StepSigma(const std::vector<WalkLegs>& walks, double leg_variance, double waypoint_sigma_m) {
  constexpr double kSmallestM = 0.03;  // sway of the body and timing of the step
  double squared_length = 0, steps = 0, legs = 0;
  for (const WalkLegs& walk : walks) {
    for (const Leg& leg : walk) {
      squared_length += leg.length_m * leg.length_m;
      steps += leg.steps;
      legs += 1;
    }
  }
  const double variance_m2 =
      leg_variance * squared_length / legs - 2.0 * waypoint_sigma_m * waypoint_sigma_m;
  return std::max(kSmallestM, std::sqrt(std::max(0.0, variance_m2) * legs / std::max(1.0, steps)));
}

class Report {
 public:
  void Set(const std::string& key, double value, std::size_t samples, const char* basis,
           double* setting) {
    *setting = value;
    values_.push_back({"factors." + key, value, samples, basis});
  }
  std::vector<CalibratedValue> Take() { return std::move(values_); }

 private:
  std::vector<CalibratedValue> values_;
};

struct LegStatistics {
  Moments walk_means;
  Line variance_over_lag;
  std::size_t pairs = 0;
};

LegStatistics Summarise(const std::vector<WalkLegs>& walks, double Leg::*value, bool circular) {
  std::vector<double> means;
  means.reserve(walks.size());
  for (const WalkLegs& legs : walks) means.push_back(WalkMean(legs, value, circular));
  const PairDifferences pairs = DifferencesWithinWalks(walks, value, circular);
  return {ClippedMoments(means), VarianceOverLag(pairs.difference, pairs.lag_s),
          pairs.difference.size()};
}

void CalibrateSteps(const std::vector<WalkLegs>& walks, double waypoint_sigma_m,
                    FactorSettings* settings, Report* report) {
  const LegStatistics scale = Summarise(walks, &Leg::log_scale, false);
  const Moments& means = scale.walk_means;
  if (means.samples >= kMinSamples) {
    report->Set("step_scale.prior_mean", std::exp(means.mean), means.samples, "walks",
                &settings->step_scale.prior_mean);
    report->Set("step_scale.prior_sigma", std::exp(means.mean) * std::sqrt(means.variance),
                means.samples, "walks", &settings->step_scale.prior_sigma);
  }
  if (scale.pairs < kMinSamples) return;
  report->Set("step_scale.walk_per_sqrt_s", std::sqrt(scale.variance_over_lag.slope), scale.pairs,
              "pairs of legs", &settings->step_scale.walk_per_sqrt_s);
  report->Set("step.sigma_along_m",
              StepSigma(walks, 0.5 * scale.variance_over_lag.intercept, waypoint_sigma_m),
              scale.pairs, "pairs of legs", &settings->step.sigma_along_m);
}

void CalibrateOffset(const std::vector<WalkLegs>& walks, double waypoint_sigma_m,
                     FactorSettings* settings, Report* report) {
  const LegStatistics offset = Summarise(walks, &Leg::heading_rad, true);
  const Moments& means = offset.walk_means;
  if (means.samples >= kMinSamples) {
    report->Set("heading_offset.prior_mean_rad", means.mean, means.samples, "walks",
                &settings->heading_offset.prior_mean_rad);
    report->Set("heading_offset.prior_sigma_rad", std::sqrt(means.variance), means.samples, "walks",
                &settings->heading_offset.prior_sigma_rad);
  }
  if (offset.pairs < kMinSamples) return;
  report->Set("heading_offset.walk_rad_per_sqrt_s", std::sqrt(offset.variance_over_lag.slope),
              offset.pairs, "pairs of legs", &settings->heading_offset.walk_rad_per_sqrt_s);
  report->Set("step.sigma_across_m",
              StepSigma(walks, 0.5 * offset.variance_over_lag.intercept, waypoint_sigma_m),
              offset.pairs, "pairs of legs", &settings->step.sigma_across_m);
}

// How walking direction and integrated yaw part, from legs compared with dead reckoning on the
// gyroscope alone.
void CalibrateIncrements(const std::vector<WalkLegs>& walks, FactorSettings* settings,
                         Report* report) {
  constexpr double kSmallestRate = 0.01;  // a phone's gyroscope alone, rad/sqrt(s)
  const PairDifferences pairs = DifferencesWithinWalks(walks, &Leg::heading_rad, true);
  if (pairs.difference.size() < kMinSamples) return;
  const double rate = VarianceOverLag(pairs.difference, pairs.lag_s).slope;
  report->Set("heading_increment.sigma_rad_per_sqrt_s", std::max(kSmallestRate, std::sqrt(rate)),
              pairs.difference.size(), "pairs of legs",
              &settings->heading_increment.sigma_rad_per_sqrt_s);
}

// Absolute heading minus integrated yaw, every `correlation_s`.
std::vector<double> HeadingMinusYaw(const Evidence& evidence, double correlation_s) {
  std::vector<double> drift;
  const Stream<double>& heading = evidence.absolute_heading_rad;
  const Stream<double>& yaw = evidence.gyro_yaw_rad;
  if (heading.empty() || yaw.empty()) return drift;
  const TimeNs end = std::min(heading.time_ns.back(), yaw.time_ns.back());
  for (TimeNs t = std::max(heading.time_ns.front(), yaw.time_ns.front()); t <= end;
       t += DurationNs(correlation_s)) {
    drift.push_back(Interpolate(heading, t) - Interpolate(yaw, t));
  }
  return drift;
}

void CalibrateSensors(const std::vector<CalibrationWalk>& walks, FactorSettings* settings,
                      Report* report) {
  constexpr double kSmallestHeadingSigma = 0.01;  // half a degree: the resolution of a compass
  constexpr double kSmallestBias = 1e-4;          // below what a walk of a minute can show
  const double step_s = settings->absolute_heading.correlation_s;
  std::vector<double> curvature, slopes;
  for (const CalibrationWalk& walk : walks) {
    const std::vector<double> drift = HeadingMinusYaw(*walk.evidence, step_s);
    // The second difference of white noise has six times its variance, and no bias or offset in it.
    for (std::size_t i = 2; i < drift.size(); ++i) {
      curvature.push_back(drift[i] - 2.0 * drift[i - 1] + drift[i - 2]);
    }
    if (drift.size() >= 5) {
      const double seconds = step_s * static_cast<double>(drift.size() - 1);
      slopes.push_back((drift.back() - drift.front()) / seconds);
    }
  }
  if (curvature.size() >= kMinSamples) {
    const Moments moments = ClippedMoments(curvature);
    report->Set("absolute_heading.sigma_rad",
                std::max(kSmallestHeadingSigma, std::sqrt(moments.variance / 6.0)), moments.samples,
                "samples", &settings->absolute_heading.sigma_rad);
  }
  if (slopes.size() >= kMinSamples) {
    const Moments moments = ClippedMoments(slopes);
    const double second_moment = moments.variance + moments.mean * moments.mean;
    report->Set("gyro_bias.prior_sigma_radps", std::max(kSmallestBias, std::sqrt(second_moment)),
                moments.samples, "walks", &settings->gyro_bias.prior_sigma_radps);
  }
}

}  // namespace

std::vector<CalibratedValue> CalibrateMotion(const Building& building,
                                             const std::vector<CalibrationWalk>& walks,
                                             double waypoint_sigma_m, FactorSettings* settings) {
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
  CalibrateSteps(absolute.empty() ? by_gyroscope : absolute, waypoint_sigma_m, settings, &report);
  CalibrateOffset(absolute, waypoint_sigma_m, settings, &report);
  CalibrateIncrements(by_gyroscope, settings, &report);
  CalibrateSensors(walks, settings, &report);
  return report.Take();
}

}  // namespace walkgraph
