#include "solvers/baselines/dead_reckoning.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace walkgraph {
namespace {

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

std::vector<PositionFix> DeadReckoningEstimator::Starts(const Site& site, const Evidence& evidence,
                                                        const DeadReckonedPath& path,
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
          (fix.position_m - path.PositionAt(fix.time_ns)) / static_cast<double>(fixes.size());
    }
    start.position_m += path.PositionAt(evidence.begin_ns);
  }
  start.time_ns = evidence.begin_ns;
  return {start};
}

EstimateResult DeadReckoningEstimator::Estimate(const Site& site, const Evidence& evidence) const {
  EstimateResult result;
  const DeadReckonedPath path = DeadReckon(site, evidence, factors_);
  if (path.source != HeadingSource::kAbsolute) {
    MarkUnobservable(&result, "no absolute heading: the first direction is unknown");
  }
  const std::vector<PositionFix> starts = Starts(site, evidence, path, &result);
  std::vector<TimeNs> times = path.position_m.time_ns;
  for (const PositionFix& start : starts) times.push_back(start.time_ns);
  for (const TimeNs time : NodeTimes(evidence, std::move(times))) {
    const auto next =
        std::upper_bound(starts.begin(), starts.end(), time,
                         [](TimeNs t, const PositionFix& start) { return t < start.time_ns; });
    const PositionFix& start = next == starts.begin() ? *next : *(next - 1);
    PoseEstimate pose;
    pose.time_ns = time;
    pose.floor = start.floor;
    pose.position_m.head<2>() =
        start.position_m + path.PositionAt(time) - path.PositionAt(start.time_ns);
    pose.position_m.z() = FloorHeight(site, start.floor);
    pose.heading_rad = path.HeadingAt(time);
    result.trajectory.poses.push_back(pose);
  }
  return result;
}

}  // namespace walkgraph
