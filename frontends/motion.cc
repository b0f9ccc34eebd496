#include "frontends/motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "frontends/signal.h"

namespace walkgraph {
namespace {

// Appends a span, joining it to the one before where they touch and are of one state.
void Append(TimeNs begin_ns, TimeNs end_ns, MotionState state, std::vector<MotionInterval>* out) {
  if (begin_ns >= end_ns) return;
  if (!out->empty() && out->back().state == state && out->back().end_ns == begin_ns) {
    out->back().end_ns = end_ns;
  } else {
    out->push_back({.begin_ns = begin_ns, .end_ns = end_ns, .state = state});
  }
}

}  // namespace

std::vector<TimeSpan> FindHandling(const Stream<Eigen::Vector3d>& up,
                                   const HandlingSettings& settings) {
  // A mean of unit vectors of length r has circular standard deviation sqrt(-2 log r).
  const double calm_length = std::exp(-0.5 * settings.tilt_spread_rad * settings.tilt_spread_rad);
  const TimeNs merge_ns = DurationNs(settings.merge_gap_s);
  const std::vector<Eigen::Vector3d> mean = CenteredMean(up.time_ns, up.value, settings.window_s);
  std::vector<TimeSpan> spans;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    if (mean[i].norm() >= calm_length) continue;
    const TimeNs t = up.time_ns[i];
    if (spans.empty() || t > spans.back().end_ns + merge_ns) {
      spans.push_back({.begin_ns = t, .end_ns = t});
    }
    spans.back().end_ns = t;
  }
  return spans;
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
