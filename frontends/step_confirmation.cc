#include "frontends/step_confirmation.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

namespace walkgraph {
namespace {

constexpr double kMinHz = 1.0, kMaxHz = 3.0, kSpacingHz = 0.05;
constexpr int kFrequencies = static_cast<int>((kMaxHz - kMinHz) / kSpacingHz + 0.5) + 1;
constexpr double kClosest = 0.6;  // of a period
constexpr int kMaxSteps = 3;      // between two peaks of one walk

// Magnitude at each frequency of the ladder. Samples count for the time until the next.
std::vector<double> Spectrum(const Stream<double>& gait, std::size_t begin, std::size_t end) {
  std::vector<double> magnitude;
  for (int k = 0; k < kFrequencies; ++k) {
    const double omega = 2 * std::numbers::pi * (kMinHz + k * kSpacingHz);
    std::complex<double> sum = 0;
    for (std::size_t i = begin; i + 1 < end; ++i) {
      const double t = SecondsBetween(gait.time_ns[begin], gait.time_ns[i]);
      const double dt = SecondsBetween(gait.time_ns[i], gait.time_ns[i + 1]);
      sum += gait.value[i] * dt * std::polar(1.0, -omega * t);
    }
    magnitude.push_back(std::abs(sum));
  }
  return magnitude;
}

// A peak that share of the way from one to the next, as strong as they are.
StepPeak Between(const StepPeak& before, const StepPeak& after, double share) {
  const TimeNs gap_ns = after.time_ns - before.time_ns;
  const auto at = [&](double s) {
    return before.time_ns + static_cast<TimeNs>(s * static_cast<double>(gap_ns));
  };
  StepPeak peak = before;
  peak.time_ns = at(share);
  peak.value = (before.value + after.value) / 2;
  peak.lowest_valley = (before.lowest_valley + after.lowest_valley) / 2;
  peak.valley_before_ns = peak.valley_after_ns = peak.time_ns;
  return peak;
}

}  // namespace

std::optional<double> WalkingFrequency(const Stream<double>& gait, TimeNs begin_ns, TimeNs end_ns) {
  const auto first = std::lower_bound(gait.time_ns.begin(), gait.time_ns.end(), begin_ns);
  const auto last = std::upper_bound(first, gait.time_ns.end(), end_ns);
  if (last - first < 4 || SecondsBetween(*first, *(last - 1)) < 2 / kMinHz) return std::nullopt;
  const std::vector<double> magnitude =
      Spectrum(gait, static_cast<std::size_t>(first - gait.time_ns.begin()),
               static_cast<std::size_t>(last - gait.time_ns.begin()));
  const auto best = std::max_element(magnitude.begin(), magnitude.end());
  if (!(*best > 0)) return std::nullopt;
  const double hz = kMinHz + kSpacingHz * static_cast<double>(best - magnitude.begin());
  if (best == magnitude.begin() || best == magnitude.end() - 1) return hz;
  // The vertex of the parabola through the best three.
  const double bend = best[-1] - 2 * best[0] + best[1];
  return bend < 0 ? hz + 0.5 * kSpacingHz * (best[-1] - best[1]) / bend : hz;
}

std::vector<StepPeak> ConfirmByFrequency(const Stream<double>& gait,
                                         const std::vector<StepPeak>& peaks,
                                         const StepDetectorSettings& settings,
                                         std::map<std::string, std::int64_t>* counts) {
  const TimeNs half_ns = DurationNs(settings.fourier_window_s) / 2;
  std::vector<StepPeak> confirmed;
  for (const StepPeak& peak : peaks) {
    const auto hz = WalkingFrequency(gait, peak.time_ns - half_ns, peak.time_ns + half_ns);
    if (confirmed.empty() || !hz) {
      confirmed.push_back(peak);
      continue;
    }
    const StepPeak before = confirmed.back();
    const double periods = SecondsBetween(before.time_ns, peak.time_ns) * *hz;
    if (periods < kClosest) {
      if (peak.value > before.value) confirmed.back() = peak;
      ++(*counts)["step_unconfirmed"];
      continue;
    }
    const int steps = static_cast<int>(std::lround(periods));
    for (int k = 1; steps <= kMaxSteps && k < steps; ++k) {
      confirmed.push_back(Between(before, peak, static_cast<double>(k) / steps));
      ++(*counts)["step_from_frequency"];
    }
    confirmed.push_back(peak);
  }
  return confirmed;
}

}  // namespace walkgraph
