#ifndef WALKGRAPH_FRONTENDS_MOTION_H_
#define WALKGRAPH_FRONTENDS_MOTION_H_

#include <Eigen/Core>
#include <vector>

#include "data/recording.h"
#include "frontends/evidence/evidence.h"
#include "frontends/settings.h"

namespace walkgraph {

struct TimeSpan {
  TimeNs begin_ns = 0;
  TimeNs end_ns = 0;
};

// Where the hand plays with the phone. Two signs, each far above what walking does:
// - turning it over: the spread of the direction of gravity in the device (circular standard
//   deviation over a window);
// - swaying it about the vertical: the yaw that goes to and fro inside a window, beyond the widest
//   turn to either side (one to the left and one to the right are a walker who rounds two corners).
// Both say "somewhere in this window", so that spans reach half a window beyond the samples that
// show them. Without gyroscope (`yaw_rad` empty) only the first counts. Spans are disjoint, sorted
// and inside the times of `up`.
std::vector<TimeSpan> FindHandling(const Stream<Eigen::Vector3d>& up, const Stream<double>& yaw_rad,
                                   const HandlingSettings& settings);

// Tiles [begin_ns, end_ns]: handling where it was found, walking from the first to the last step of
// each run of steps, standing elsewhere. `handling` and `steps` are sorted and do not overlap.
std::vector<MotionInterval> ClassifyMotion(TimeNs begin_ns, TimeNs end_ns,
                                           const std::vector<TimeSpan>& handling,
                                           const std::vector<StepEvidence>& steps);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_MOTION_H_
