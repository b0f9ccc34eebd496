#include "solvers/lagged_batch.h"

#include <utility>

#include "solvers/evidence_order.h"

namespace walkgraph {

EstimateResult LaggedBatch::Estimate(const Site& site, const Evidence& evidence) const {
  constexpr double kIntervalS = 2.0;
  Trajectory reported;
  TimeNs next_ns = evidence.begin_ns;  // nodes before it are reported
  for (TimeNs now_ns = evidence.begin_ns + DurationNs(lag_s_); now_ns < evidence.end_ns;
       now_ns += DurationNs(kIntervalS)) {
    const EstimateResult seen = batch_.Estimate(site, EvidenceUntil(evidence, now_ns));
    // Until there is evidence of a place the window waits, too.
    if (seen.status != EstimateStatus::kOk) continue;
    const TimeNs until_ns = now_ns - DurationNs(lag_s_) + DurationNs(kIntervalS);
    for (const PoseEstimate& pose : seen.trajectory.poses) {
      if (pose.time_ns >= next_ns && pose.time_ns < until_ns) reported.poses.push_back(pose);
    }
    next_ns = until_ns;
  }
  EstimateResult result = batch_.Estimate(site, evidence);
  for (const PoseEstimate& pose : result.trajectory.poses) {
    if (pose.time_ns >= next_ns) reported.poses.push_back(pose);
  }
  result.trajectory = std::move(reported);
  return result;
}

}  // namespace walkgraph
