#include "solvers/baselines/discrete_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace walkgraph {
namespace {

// How far the offset of the dead-reckoned heading wanders within an epoch. A gyroscope's bias turns
// it steadily; for bins that know no bias that is one more cause of wandering.
double WanderVariance(HeadingSource source, const FactorSettings& factors, double epoch_s) {
  if (source == HeadingSource::kAbsolute) {
    return std::pow(factors.heading_offset.walk_rad_per_sqrt_s, 2) * epoch_s;
  }
  const double bias = factors.gyro_bias.mode == StateMode::kActive
                          ? factors.gyro_bias.prior_sigma_radps * epoch_s
                          : 0.0;
  return std::pow(factors.heading_increment.sigma_rad_per_sqrt_s, 2) * epoch_s + bias * bias;
}

// Cost of a bin's change, over that of none, that gives steps of one bin this variance. A density
// at the bin's middle would forbid what wanders little in an epoch and far in a minute.
float ChangeNats(double variance, double width) {
  constexpr double kMost = 1.0 / 3;
  const double change = std::clamp(0.5 * variance / (width * width), 1e-9, kMost);
  return static_cast<float>(std::log((1 - 2 * change) / change));
}

}  // namespace

HeadingBins MakeBins(HeadingSource source, const FactorSettings& factors,
                     const DiscreteSettings& settings, double epoch_s) {
  const HeadingOffsetSettings& offset = factors.heading_offset;
  HeadingBins bins;
  const double width = settings.heading_bin_rad;
  if (source == HeadingSource::kGyroscope) {
    const int count = std::max(1, static_cast<int>(std::lround(2.0 * std::numbers::pi / width)));
    for (int i = 0; i < count; ++i) {
      bins.offset_rad.push_back(2.0 * std::numbers::pi * i / count);
    }
    bins.prior_nats.assign(static_cast<std::size_t>(count), 0.0F);
    bins.circular = count > 1;
  } else {
    const bool free = source == HeadingSource::kAbsolute && offset.mode == StateMode::kActive;
    const double range = settings.heading_range_sigmas * offset.prior_sigma_rad / width;
    const int half = free ? static_cast<int>(std::lround(range)) : 0;
    for (int i = -half; i <= half; ++i) {
      bins.offset_rad.push_back(i * width);
      const double z = i * width / offset.prior_sigma_rad;
      bins.prior_nats.push_back(free ? static_cast<float>(0.5 * z * z) : 0.0F);
    }
  }
  bins.change_nats = ChangeNats(WanderVariance(source, factors, epoch_s), width);
  return bins;
}

Transition MakeTransition(const Evidence& evidence, const DeadReckonedPath& walk, TimeNs begin,
                          TimeNs end, const FactorSettings& factors,
                          const DiscreteSettings& settings) {
  Transition transition;
  int steps = 0;
  double distance = 0;
  for (const StepEvidence& step : evidence.steps) {
    if (step.end_ns <= begin || step.end_ns > end) continue;
    ++steps;
    distance += step.length_m;
  }
  const StandingSettings& standing = factors.standing;
  const double seconds = SecondsBetween(begin, end);
  double variance = standing.sigma_mps * standing.sigma_mps * seconds;
  // Without an accelerometer nobody knows whether the person walks.
  if (evidence.motion.empty() && evidence.steps.empty())
    variance = std::pow(standing.unseen_mps * seconds, 2);
  if (walk.source == HeadingSource::kNone) {
    variance += 0.5 * distance * distance;
  } else {
    transition.displacement_m = walk.PositionAt(end) - walk.PositionAt(begin);
    const double moved = transition.displacement_m.norm();
    const double along = factors.step.sigma_along_m, across = factors.step.sigma_across_m;
    const double scale = moved * factors.step_scale.prior_sigma;
    // Rounding to a bin, and what the heading errs over an epoch beyond its offset.
    const AbsoluteHeadingSettings& heading = factors.absolute_heading;
    const double error = heading.sigma_rad * std::sqrt(heading.correlation_s /
                                                       std::max(seconds, heading.correlation_s));
    const double turn = moved * std::hypot(settings.heading_bin_rad / std::sqrt(12.0), error);
    variance += 0.5 * (steps * (along * along + across * across) + scale * scale + turn * turn);
  }
  // Both ends are rounded to their cells.
  transition.variance_m2 = variance + settings.spacing_m * settings.spacing_m / 6.0;
  return transition;
}

}  // namespace walkgraph
