#include "frontends/steps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "frontends/gravity.h"
#include "frontends/signal.h"
#include "frontends/step_confirmation.h"

namespace walkgraph {
namespace {

struct Extreme {
  std::size_t index = 0;
  double value = 0;
};

// The swing that a step at each sample must have.
std::vector<double> Thresholds(const Stream<double>& gait, const StepDetectorSettings& settings) {
  std::vector<double> square(gait.size());
  std::transform(gait.value.begin(), gait.value.end(), square.begin(),
                 [](double a) { return a * a; });
  std::vector<double> out = CenteredMean(gait.time_ns, square, settings.rms_window_s);
  const double swing_per_rms = 2 * std::numbers::sqrt2;  // of a sine
  for (double& value : out) {
    const double local_swing = swing_per_rms * std::sqrt(std::max(value, 0.0));
    value = std::max(settings.min_swing_mps2, settings.swing_ratio * local_swing);
  }
  return out;
}

// Alternating valleys and peaks, beginning with a valley: the extremes between zero crossings. A
// crossing counts once the signal is a quarter of the threshold beyond zero.
std::vector<Extreme> AlternatingExtremes(const std::vector<double>& signal,
                                         const std::vector<double>& threshold) {
  std::vector<Extreme> out;
  if (signal.empty()) return out;
  Extreme current{.index = 0, .value = std::min(signal.front(), 0.0)};
  double sign = -1;  // +1 inside a peak, -1 inside a valley
  for (std::size_t i = 0; i < signal.size(); ++i) {
    if (-sign * signal[i] > threshold[i] / 4) {
      out.push_back(current);
      sign = -sign;
      current = {.index = i, .value = signal[i]};
    } else if (sign * signal[i] > sign * current.value) {
      current = {.index = i, .value = signal[i]};
    }
  }
  out.push_back(current);
  return out;
}

std::vector<StepPeak> FindPeaks(const Stream<double>& gait, const StepDetectorSettings& settings) {
  const std::vector<double> threshold = Thresholds(gait, settings);
  const std::vector<Extreme> extremes = AlternatingExtremes(gait.value, threshold);
  std::vector<StepPeak> peaks;
  for (std::size_t i = 1; i < extremes.size(); i += 2) {
    const Extreme& before = extremes[i - 1];
    const Extreme& after = i + 1 < extremes.size() ? extremes[i + 1] : extremes[i];
    peaks.push_back({.time_ns = gait.time_ns[extremes[i].index],
                     .value = extremes[i].value,
                     .valley_before_ns = gait.time_ns[before.index],
                     .valley_after_ns = gait.time_ns[after.index],
                     .lowest_valley = std::min(before.value, after.value),
                     .threshold = threshold[extremes[i].index]});
  }
  return peaks;
}

// Peaks high enough, the higher one of two that are too close.
std::vector<StepPeak> StrongPeaks(const std::vector<StepPeak>& peaks,
                                  const StepDetectorSettings& settings) {
  const TimeNs min_interval_ns = DurationNs(settings.min_interval_s);
  std::vector<StepPeak> strong;
  for (const StepPeak& peak : peaks) {
    if (peak.Swing() < peak.threshold) continue;
    const bool close = !strong.empty() && peak.time_ns - strong.back().time_ns < min_interval_ns;
    if (!close) {
      strong.push_back(peak);
    } else if (peak.value > strong.back().value) {
      strong.back() = peak;
    }
  }
  return strong;
}

std::vector<StepPeak> OutsideHandling(const std::vector<StepPeak>& peaks,
                                      const std::vector<TimeSpan>& handling,
                                      std::map<std::string, std::int64_t>* counts) {
  std::vector<StepPeak> outside;
  std::size_t h = 0;
  for (const StepPeak& peak : peaks) {
    while (h < handling.size() && handling[h].end_ns < peak.time_ns) ++h;
    if (h < handling.size() && handling[h].begin_ns <= peak.time_ns) {
      ++(*counts)["step_while_handling"];
    } else {
      outside.push_back(peak);
    }
  }
  return outside;
}

// Appends the steps of peaks [begin, end), all closer together than the longest interval.
void AppendRun(const std::vector<StepPeak>& peaks, std::size_t begin, std::size_t end,
               const StepDetectorSettings& settings, std::vector<StepEvidence>* steps) {
  const TimeNs first_half_ns = (peaks[begin + 1].time_ns - peaks[begin].time_ns) / 2;
  const TimeNs last_half_ns = (peaks[end - 1].time_ns - peaks[end - 2].time_ns) / 2;
  TimeNs from_ns = peaks[begin].time_ns - first_half_ns;
  for (std::size_t i = begin; i < end; ++i) {
    const TimeNs to_ns = i + 1 < end
                             ? (peaks[i].valley_after_ns + peaks[i + 1].valley_before_ns) / 2
                             : peaks[i].time_ns + last_half_ns;
    steps->push_back({.begin_ns = from_ns,
                      .end_ns = to_ns,
                      .length_m = settings.weinberg_k * std::pow(peaks[i].Swing(), 0.25)});
    from_ns = to_ns;
  }
}

// Keeps the steps inside the recorded span and out of handling and of each other.
void ClampSteps(const Stream<double>& gait, const std::vector<TimeSpan>& handling,
                std::vector<StepEvidence>* steps) {
  std::size_t h = 0;
  TimeNs earliest_ns = gait.time_ns.front();
  for (std::size_t i = 0; i < steps->size(); ++i) {
    StepEvidence& step = (*steps)[i];
    while (h < handling.size() && handling[h].end_ns <= step.end_ns &&
           handling[h].begin_ns < step.begin_ns) {
      earliest_ns = std::max(earliest_ns, handling[h].end_ns);
      ++h;
    }
    TimeNs latest_ns = gait.time_ns.back();
    if (h < handling.size()) latest_ns = std::min(latest_ns, handling[h].begin_ns);
    step.begin_ns = std::max(step.begin_ns, earliest_ns);
    step.end_ns = std::min(step.end_ns, std::max(latest_ns, step.begin_ns));
    earliest_ns = step.end_ns;
  }
}

}  // namespace

Stream<double> GaitSignal(const Stream<Eigen::Vector3d>& accelerometer_mps2,
                          const Stream<Eigen::Vector3d>& up, const StepDetectorSettings& settings) {
  Stream<double> gait;
  if (up.empty()) return gait;
  const std::vector<Eigen::Vector3d> vertical = UpAt(up, accelerometer_mps2.time_ns);
  gait.time_ns = accelerometer_mps2.time_ns;
  gait.value.reserve(gait.size());
  for (std::size_t i = 0; i < accelerometer_mps2.size(); ++i) {
    gait.value.push_back(accelerometer_mps2.value[i].dot(vertical[i]) - kStandardGravityMps2);
  }
  for (int pass = 0; pass < 2; ++pass) {
    gait.value = CenteredMean(gait.time_ns, gait.value, settings.smoothing_s);
  }
  const std::vector<double> trend = CenteredMean(gait.time_ns, gait.value, settings.detrend_s);
  for (std::size_t i = 0; i < gait.size(); ++i) gait.value[i] -= trend[i];
  return gait;
}

std::vector<StepEvidence> DetectSteps(const Stream<double>& gait,
                                      const std::vector<TimeSpan>& handling,
                                      const StepDetectorSettings& settings,
                                      std::map<std::string, std::int64_t>* counts) {
  std::vector<StepEvidence> steps;
  if (gait.empty()) return steps;
  std::vector<StepPeak> peaks =
      OutsideHandling(StrongPeaks(FindPeaks(gait, settings), settings), handling, counts);
  if (settings.fourier_confirmation) peaks = ConfirmByFrequency(gait, peaks, settings, counts);
  const TimeNs max_interval_ns = DurationNs(settings.max_interval_s);
  for (std::size_t begin = 0; begin < peaks.size();) {
    std::size_t end = begin + 1;
    while (end < peaks.size() && peaks[end].time_ns - peaks[end - 1].time_ns <= max_interval_ns) {
      ++end;
    }
    if (end - begin == 1) {
      ++(*counts)["step_alone"];
    } else {
      AppendRun(peaks, begin, end, settings, &steps);
    }
    begin = end;
  }
  ClampSteps(gait, handling, &steps);
  return steps;
}

}  // namespace walkgraph
