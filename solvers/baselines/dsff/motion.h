#ifndef WALKGRAPH_SOLVERS_BASELINES_DSFF_MOTION_H_
#define WALKGRAPH_SOLVERS_BASELINES_DSFF_MOTION_H_

#include <optional>
#include <vector>

#include "data/trajectory.h"
#include "factors/dead_reckoning.h"
#include "frontends/evidence/evidence.h"

namespace walkgraph {

// What the relative sensors say of the way to an epoch from the one before.
struct DsffMotion {
  double distance_m = 0;           // straight, from where the person was to where the person is
  double heading_rad = 0;          // of that way, building frame
  double steps = 0;                // detected on it, by their shares
  std::optional<double> height_m;  // at the epoch, over that of the first
};

// The evidence with the integrated gyroscope in place of its absolute heading, turned so that the
// two agree in the mean over the walk (the paper tells no start). Precondition: it has both.
Evidence WithGyroscopeHeading(const Evidence& evidence);

// One for every epoch; nothing moves before the first. `path` is dead reckoned from that heading.
std::vector<DsffMotion> MeasureDsffMotion(const Evidence& evidence, const DeadReckonedPath& path,
                                          const std::vector<TimeNs>& epochs);

// Which sensors the truth stands in for.
struct TrueSensors {
  bool distance = false, heading = false, height = false;
  bool any() const { return distance || heading || height; }
};

// The true values in place of the sensors named, over the time that the truth covers. A true way
// under 0.3 m has no heading that a survey could tell; there the sensor's stays.
void SubstituteTruth(const Trajectory& truth, const std::vector<TimeNs>& epochs,
                     const TrueSensors& sensors, std::vector<DsffMotion>* motion);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_DSFF_MOTION_H_
