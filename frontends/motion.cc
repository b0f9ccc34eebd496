#include "frontends/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "frontends/signal.h"

namespace walkgraph {
namespace {

// Swings below this are gait and noise (our choice).
constexpr double kLeastSwingRad = 0.1;

// Appends a span, joining it to the one before where they touch and are of one state.
void Append(TimeNs begin_ns, TimeNs end_ns, MotionState state, std::vector<MotionInterval>* out) {
  if (begin_ns >= end_ns) return;
  if (!out->empty() && out->back().state == state && out->back().end_ns == begin_ns) {
    out->back().end_ns = end_ns;
  } else {
    out->push_back({.begin_ns = begin_ns, .end_ns = end_ns, .state = state});
  }
}

// Every run of samples that `shows` the sign, half a window longer on both sides.
template <typename Predicate>
std::vector<TimeSpan> SpansWhere(const std::vector<TimeNs>& time_ns, double window_s,
                                 const Predicate& shows) {
  const TimeNs half_ns = DurationNs(window_s / 2);
  std::vector<TimeSpan> spans;
  bool inside = false;
  for (std::size_t i = 0; i < time_ns.size(); ++i) {
    const bool now = shows(i);
    if (now && !inside) spans.push_back({.begin_ns = time_ns[i] - half_ns, .end_ns = 0});
    if (now) spans.back().end_ns = time_ns[i] + half_ns;
    inside = now;
  }
  return spans;
}

std::vector<TimeSpan> TurnedOver(const Stream<Eigen::Vector3d>& up,
                                 const HandlingSettings& settings) {
  // A mean of unit vectors of length r has circular standard deviation sqrt(-2 log r).
  const double calm_length = std::exp(-0.5 * settings.tilt_spread_rad * settings.tilt_spread_rad);
  const std::vector<Eigen::Vector3d> mean =
      CenteredMean(up.time_ns, up.value, settings.tilt_window_s);
  return SpansWhere(up.time_ns, settings.tilt_window_s,
                    [&](std::size_t i) { return mean[i].norm() < calm_length; });
}

// The yaw of [first, last] as swings from one extreme to the next; what turns back by less than
// kLeastSwingRad is part of the swing. Returns twice what the swings to one side add up to beyond
// the widest of them, of the side where that is less, rad: a turn to the left and one to the right,
// as of a walker who rounds two corners, are none.
double SwayBeyondTwoTurns(const std::vector<double>& yaw_rad, std::size_t first, std::size_t last) {
  double low = yaw_rad[first], high = yaw_rad[first];  // since the last extreme
  double direction = 0, start = yaw_rad[first];
  std::array<double, 2> sum{}, widest{};  // by side
  const auto end_swing = [&](double to) {
    const double swing = std::abs(to - start);
    const std::size_t side = direction > 0 ? 1 : 0;
    sum[side] += swing;
    widest[side] = std::max(widest[side], swing);
    start = to;
  };
  for (std::size_t i = first; i <= last; ++i) {
    low = std::min(low, yaw_rad[i]);
    high = std::max(high, yaw_rad[i]);
    if (direction <= 0 && yaw_rad[i] > low + kLeastSwingRad) {
      if (direction < 0) end_swing(low);
      if (direction == 0) start = low;
      direction = 1;
      high = yaw_rad[i];
    } else if (direction >= 0 && yaw_rad[i] < high - kLeastSwingRad) {
      if (direction > 0) end_swing(high);
      if (direction == 0) start = high;
      direction = -1;
      low = yaw_rad[i];
    }
  }
  if (direction != 0) end_swing(direction > 0 ? high : low);
  return 2 * std::min(sum[0] - widest[0], sum[1] - widest[1]);
}

std::vector<TimeSpan> Swayed(const Stream<double>& yaw_rad, const HandlingSettings& settings) {
  Stream<double> yaw = yaw_rad;
  yaw.value = CenteredMean(yaw.time_ns, yaw.value, settings.yaw_smoothing_s);
  const std::size_t n = yaw.size();
  std::vector<double> way(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    way[i] = way[i - 1] + std::abs(yaw.value[i] - yaw.value[i - 1]);
  }
  const TimeNs half_ns = DurationNs(settings.sway_window_s / 2);
  std::size_t first = 0;
  std::size_t last = 0;
  return SpansWhere(yaw.time_ns, settings.sway_window_s, [&](std::size_t i) {
    while (yaw.time_ns[first] < yaw.time_ns[i] - half_ns) ++first;
    while (last + 1 < n && yaw.time_ns[last + 1] <= yaw.time_ns[i] + half_ns) ++last;
    // The way beyond the net change is never less than the sway, and known at once.
    const double net = std::abs(yaw.value[last] - yaw.value[first]);
    return way[last] - way[first] - net > settings.sway_rad &&
           SwayBeyondTwoTurns(yaw.value, first, last) > settings.sway_rad;
  });
}

// Sorted, cut to [begin_ns, end_ns] and without gaps of up to merge_gap_s, to its ends included.
std::vector<TimeSpan> Join(std::vector<TimeSpan> spans, TimeNs begin_ns, TimeNs end_ns,
                           double merge_gap_s) {
  const TimeNs gap_ns = DurationNs(merge_gap_s);
  std::sort(spans.begin(), spans.end(),
            [](const TimeSpan& a, const TimeSpan& b) { return a.begin_ns < b.begin_ns; });
  std::vector<TimeSpan> joined;
  for (TimeSpan span : spans) {
    if (span.begin_ns <= begin_ns + gap_ns) span.begin_ns = begin_ns;
    if (span.end_ns >= end_ns - gap_ns) span.end_ns = end_ns;
    if (joined.empty() || span.begin_ns > joined.back().end_ns + gap_ns) {
      joined.push_back(span);
    } else {
      joined.back().end_ns = std::max(joined.back().end_ns, span.end_ns);
    }
  }
  return joined;
}

}  // namespace

std::vector<TimeSpan> FindHandling(const Stream<Eigen::Vector3d>& up, const Stream<double>& yaw_rad,
                                   const HandlingSettings& settings) {
  std::vector<TimeSpan> spans;
  if (up.empty()) return spans;
  spans = TurnedOver(up, settings);
  const std::vector<TimeSpan> swayed = Swayed(yaw_rad, settings);
  spans.insert(spans.end(), swayed.begin(), swayed.end());
  return Join(std::move(spans), up.time_ns.front(), up.time_ns.back(), settings.merge_gap_s);
}

std::vector<MotionInterval> ClassifyMotion(TimeNs begin_ns, TimeNs end_ns,
                                           const std::vector<TimeSpan>& handling,
                                           const std::vector<StepEvidence>& steps) {
  std::vector<MotionInterval> out;
  TimeNs done_ns = begin_ns;
  const auto add = [&](TimeNs from_ns, TimeNs to_ns, MotionState state) {
    const TimeNs from = std::clamp(from_ns, done_ns, end_ns);
    const TimeNs to = std::clamp(to_ns, from, end_ns);
    Append(done_ns, from, MotionState::kStanding, &out);
    Append(from, to, state, &out);
    done_ns = to;
  };
  std::size_t h = 0;
  for (const StepEvidence& step : steps) {
    for (; h < handling.size() && handling[h].begin_ns < step.begin_ns; ++h) {
      add(handling[h].begin_ns, handling[h].end_ns, MotionState::kHandling);
    }
    add(step.begin_ns, step.end_ns, MotionState::kWalking);
  }
  for (; h < handling.size(); ++h) {
    add(handling[h].begin_ns, handling[h].end_ns, MotionState::kHandling);
  }
  Append(done_ns, end_ns, MotionState::kStanding, &out);
  return out;
}

}  // namespace walkgraph
