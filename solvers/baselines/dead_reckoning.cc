#include "solvers/baselines/dead_reckoning.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace walkgraph {
namespace {

// The walking direction at any time from whatever there is: absolute heading, else the gyroscope
// from an unknown start, else nothing.
double HeadingAt(const Evidence& evidence, const WalkingDirection& direction, TimeNs time_ns) {
  if (direction.available()) return direction.At(time_ns);
  return evidence.gyro_yaw_rad.empty() ? 0.0 : Interpolate(evidence.gyro_yaw_rad, time_ns);
}

TimeNs Middle(const StepEvidence& step) {
  return step.begin_ns + (step.end_ns - step.begin_ns) / 2;
}

PositionFix FromAnchor(const PositionAnchor& anchor) {
  PositionFix fix;
  fix.time_ns = anchor.time_ns;
  fix.position_m = anchor.position_m;
  fix.floor = anchor.floor;
  return fix;
}

void MarkUnobservable(EstimateResult* result, const char* message) {
  result->status = EstimateStatus::kUnobservable;
  result->messages.emplace_back(message);
}

}  // namespace

StepPath::StepPath(const std::vector<StepEvidence>& steps, const std::vector<double>& heading_rad,
                   double step_scale)
    : steps_(steps), before_{Eigen::Vector2d::Zero()} {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double length_m = step_scale * steps[i].length_m;
    before_.emplace_back(before_.back() + length_m * Eigen::Vector2d(std::cos(heading_rad[i]),
                                                                     std::sin(heading_rad[i])));
  }
}

Eigen::Vector2d StepPath::At(TimeNs time_ns) const {
  const auto next =
      std::upper_bound(steps_.begin(), steps_.end(), time_ns,
                       [](TimeNs time, const StepEvidence& step) { return time < step.begin_ns; });
  if (next == steps_.begin()) return before_.front();
  const StepEvidence& step = *(next - 1);
  const auto i = static_cast<std::size_t>(next - steps_.begin());
  const double duration_s = SecondsBetween(step.begin_ns, step.end_ns);
  const double done =
      duration_s > 0 ? std::min(1.0, SecondsBetween(step.begin_ns, time_ns) / duration_s) : 1.0;
  return before_[i - 1] + done * (before_[i] - before_[i - 1]);
}

std::vector<PositionFix> DeadReckoningEstimator::Starts(const Site& site, const Evidence& evidence,
                                                        const StepPath& path,
                                                        EstimateResult* result) const {
  std::vector<PositionFix> starts;
  for (const PositionAnchor& anchor : evidence.anchors) starts.push_back(FromAnchor(anchor));
  std::stable_sort(starts.begin(), starts.end(), [](const PositionFix& a, const PositionFix& b) {
    return a.time_ns < b.time_ns;
  });
  if (!starts.empty()) return starts;

  std::vector<PositionFix> fixes = WknnFixes(site, evidence, wknn_);
  PositionFix start;
  if (fixes.empty()) {
    MarkUnobservable(result, "no Wi-Fi fix and no anchor: starts at the centroid of the survey");
    start = SurveyCentroid(site, evidence.floor);
  } else {
    fixes.resize(
        std::min(fixes.size(), static_cast<std::size_t>(std::max(1, settings_.start_scans))));
    start.floor = fixes.front().floor;
    for (const PositionFix& fix : fixes) {
      start.position_m +=
          (fix.position_m - path.At(fix.time_ns)) / static_cast<double>(fixes.size());
    }
    start.position_m += path.At(evidence.begin_ns);
  }
  start.time_ns = evidence.begin_ns;
  return {start};
}

EstimateResult DeadReckoningEstimator::Estimate(const Site& site, const Evidence& evidence) const {
  EstimateResult result;
  const WalkingDirection direction(site, evidence, factors_.heading_offset);
  if (!direction.available() && !evidence.steps.empty()) {
    MarkUnobservable(&result, "no absolute heading: the first direction is unknown");
  }
  std::vector<double> step_heading;
  std::vector<TimeNs> step_ends;
  for (const StepEvidence& step : evidence.steps) {
    step_heading.push_back(HeadingAt(evidence, direction, Middle(step)));
    step_ends.push_back(step.end_ns);
  }
  const StepScaleSettings& scale = factors_.step_scale;
  const StepPath path(evidence.steps, step_heading,
                      scale.mode == StateMode::kAbsent ? 1.0 : scale.prior_mean);
  const std::vector<PositionFix> starts = Starts(site, evidence, path, &result);
  for (const TimeNs time : NodeTimes(evidence, step_ends)) {
    const auto next =
        std::upper_bound(starts.begin(), starts.end(), time,
                         [](TimeNs t, const PositionFix& start) { return t < start.time_ns; });
    const PositionFix& start = next == starts.begin() ? *next : *(next - 1);
    PoseEstimate pose;
    pose.time_ns = time;
    pose.floor = start.floor;
    pose.position_m.head<2>() = start.position_m + path.At(time) - path.At(start.time_ns);
    pose.position_m.z() = FloorHeight(site, start.floor);
    pose.heading_rad = HeadingAt(evidence, direction, time);
    result.trajectory.poses.push_back(pose);
  }
  return result;
}

}  // namespace walkgraph
