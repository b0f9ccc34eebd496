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

// Where the hand turns the phone over: the spread of the direction of gravity in the device
// (circular standard deviation over a window) is far above what walking does. Spans are disjoint
// and sorted.
std::vector<TimeSpan> FindHandling(const Stream<Eigen::Vector3d>& up,
                                   const HandlingSettings& settings);

// Tiles [begin_ns, end_ns]: handling where it was found, walking from the first to the last step of
// each run of steps, standing elsewhere. `handling` and `steps` are sorted and do not overlap.
std::vector<MotionInterval> ClassifyMotion(TimeNs begin_ns, TimeNs end_ns,
                                           const std::vector<TimeSpan>& handling,
                                           const std::vector<StepEvidence>& steps);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_MOTION_H_
