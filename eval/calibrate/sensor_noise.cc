#include "eval/calibrate/sensor_noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "data/angle.h"
#include "eval/calibrate/robust_moments.h"

namespace walkgraph {
namespace {

// Drift of absolute heading against integrated yaw, rad/s; nothing for short walks. The median over
// spans of the walk, in each of which it is less than half a turn: a phone that is held upright for
// a moment has a heading that turns round and may come back by the other way, and from then on its
// unwrapped heading is whole turns off.
std::optional<double> DriftRate(const Evidence& evidence) {
  constexpr double kMinSeconds = 10, kLongestSpanS = 20, kIntervalS = 0.5;
  const Stream<double>& heading = evidence.absolute_heading_rad;
  const Stream<double>& yaw = evidence.gyro_yaw_rad;
  if (heading.empty() || yaw.empty()) return std::nullopt;
  const TimeNs begin = std::max(heading.time_ns.front(), yaw.time_ns.front());
  const TimeNs end = std::min(heading.time_ns.back(), yaw.time_ns.back());
  const double seconds = SecondsBetween(begin, end);
  if (seconds < kMinSeconds) return std::nullopt;
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

// Heights by the barometer between waypoints of one floor, pair by pair.
struct LevelHeights {
  std::vector<double> difference;
  std::vector<double> lag_s;
  double own_variance = 0;  // as the evidence has it, summed over the samples
  std::size_t samples = 0;
  std::size_t stretches = 0;
};

// Of the samples with these indices. Farther pairs are many and say little more.
void AddStretch(const Evidence& evidence, std::size_t begin, std::size_t end, LevelHeights* all) {
  constexpr double kMostLagS = 60;
  const Stream<double>& heights = evidence.barometric_height_m;
  if (end - begin >= 2) ++all->stretches;
  for (std::size_t i = begin; i < end; ++i) {
    ++all->samples;
    all->own_variance += std::pow(evidence.barometric_height_sigma_m[i], 2);
    for (std::size_t j = i + 1; j < end; ++j) {
      const double lag_s = SecondsBetween(heights.time_ns[i], heights.time_ns[j]);
      if (lag_s > kMostLagS) break;
      all->difference.push_back(heights.value[j] - heights.value[i]);
      all->lag_s.push_back(lag_s);
    }
  }
}

void AddWalk(const CalibrationWalk& walk, LevelHeights* all) {
  const std::vector<Waypoint>& waypoints = walk.truth->waypoints;
  const std::vector<TimeNs>& times = walk.evidence->barometric_height_m.time_ns;
  for (auto first = waypoints.begin(); first != waypoints.end();) {
    const auto next = std::find_if(first, waypoints.end(), [&](const Waypoint& waypoint) {
      return waypoint.floor != first->floor;
    });
    const auto begin = std::lower_bound(times.begin(), times.end(), first->time_ns);
    const auto end = std::upper_bound(begin, times.end(), std::prev(next)->time_ns);
    AddStretch(*walk.evidence, static_cast<std::size_t>(begin - times.begin()),
               static_cast<std::size_t>(end - times.begin()), all);
    first = next;
  }
}

}  // namespace

void CalibrateGyroscopeBias(const std::vector<CalibrationWalk>& walks, GyroBiasSettings* settings,
                            std::vector<CalibratedValue>* values) {
  constexpr double kSmallestBias = 1e-4;  // below what a walk of a minute can show, rad/s
  std::vector<double> rates;
  for (const CalibrationWalk& walk : walks) {
    const std::optional<double> rate = DriftRate(*walk.evidence);
    if (rate) rates.push_back(*rate);
  }
  if (rates.size() < kMinCalibrationSamples) return;
  const Moments moments = ClippedMoments(rates);
  const double second_moment = moments.variance + moments.mean * moments.mean;
  SetCalibrated("gyro_bias.prior_sigma_radps", std::max(kSmallestBias, std::sqrt(second_moment)),
                moments.samples, "walks", &settings->prior_sigma_radps, values);
}

void CalibrateBarometer(const std::vector<CalibrationWalk>& walks, BarometricSettings* barometer,
                        BarometricOffsetSettings* offset, std::vector<CalibratedValue>* values) {
  constexpr double kSmallestSigmaM = 0.03;  // resolution of a phone's barometer, 0.004 hPa
  constexpr double kSmallestWalk = 0.003;   // 0.02 hPa in an hour: the calmest weather
  LevelHeights heights;
  for (const CalibrationWalk& walk : walks) AddWalk(walk, &heights);
  if (heights.stretches < kMinCalibrationSamples) return;
  const Line line = VarianceOverLag(heights.difference, heights.lag_s);
  const double own = heights.own_variance / static_cast<double>(heights.samples);
  const double sigma_m = std::sqrt(std::max(0.0, 0.5 * line.intercept - own));
  SetCalibrated("barometric.sigma_m", std::max(kSmallestSigmaM, sigma_m), heights.samples,
                "heights", &barometer->sigma_m, values);
  SetCalibrated("barometric_offset.walk_m_per_sqrt_s",
                std::max(kSmallestWalk, std::sqrt(line.slope)), heights.difference.size(),
                "pairs of heights", &offset->walk_m_per_sqrt_s, values);
}

}  // namespace walkgraph
