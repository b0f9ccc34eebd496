#include "solvers/floor_by_floor.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "solvers/baselines/floor_tracker.h"
#include "solvers/evidence_order.h"

namespace walkgraph {
namespace {

Evidence During(const FloorStay& stay, const Evidence& evidence) {
  Evidence part = EvidenceSince(EvidenceUntil(evidence, stay.end_ns), stay.begin_ns);
  part.floor = stay.floor;
  return part;
}

void Append(EstimateResult part, EstimateResult* whole) {
  std::vector<PoseEstimate>& poses = whole->trajectory.poses;
  for (const PoseEstimate& pose : part.trajectory.poses) {
    if (poses.empty() || pose.time_ns > poses.back().time_ns) poses.push_back(pose);
  }
  whole->slow_states.insert(whole->slow_states.end(), part.slow_states.begin(),
                            part.slow_states.end());
  for (std::string& message : part.messages) {
    if (std::find(whole->messages.begin(), whole->messages.end(), message) ==
        whole->messages.end()) {
      whole->messages.push_back(std::move(message));
    }
  }
}

}  // namespace

EstimateResult FloorByFloor::Estimate(const Site& site, const Evidence& evidence) const {
  if (evidence.floor) return method_->Estimate(site, evidence);
  const FloorPath path = TrackFloors(site, evidence, factors_).path;
  EstimateResult whole;
  whole.status = EstimateStatus::kUnobservable;
  if (path.stays().size() > 1) {
    for (const FloorStay& stay : path.stays()) {
      EstimateResult part = method_->Estimate(site, During(stay, evidence));
      if (part.status != EstimateStatus::kOk) continue;
      whole.status = EstimateStatus::kOk;
      Append(std::move(part), &whole);
    }
  }
  if (whole.status == EstimateStatus::kOk) return whole;
  Evidence on_main_floor = evidence;
  on_main_floor.floor = path.Main();
  return method_->Estimate(site, on_main_floor);
}

}  // namespace walkgraph
