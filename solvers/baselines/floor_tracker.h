#ifndef WALKGRAPH_SOLVERS_BASELINES_FLOOR_TRACKER_H_
#define WALKGRAPH_SOLVERS_BASELINES_FLOOR_TRACKER_H_

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "factors/floor_path.h"
#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// On which floor a walk was when.
struct FloorTrack {
  std::vector<TimeNs> time_ns;  // of the epochs
  std::vector<int> floors;      // columns of `probability`, ascending
  // Posterior of each floor at each epoch; on the way between levels the remainder to one.
  Eigen::MatrixXd probability;
  FloorPath path = 0;  // the most probable of floors and "between" at each epoch

  // Posterior of a floor at a time: that of the nearest epoch. 0 for a floor that is no column.
  double ProbabilityAt(int floor, TimeNs time_ns) const;
};

// A hidden Markov model over the surveyed floors and the way between them, and the offset of the
// barometer, on a grid of heights, which connects them: at offset b the person's height is H - b, H
// the height by the barometer. On a floor that is the floor's, between floors any. Radio evidence
// tells the floors apart by the survey's own (see FloorSounds). Where the survey has the same model
// of phone, its offset then and the time since are a prior of the offset. Without a
// barometer, or heights of the floors, the model is that of the floors alone. Where the evidence
// gives a floor that is the answer, and where only one is surveyed that one.
//
// `lag_s`: what is said about an epoch heeds evidence until so long after it (that printed by
// then). The default is the whole walk's.
FloorTrack TrackFloors(const Site& site, const Evidence& evidence, const FactorSettings& settings,
                       double lag_s = std::numeric_limits<double>::infinity());

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_FLOOR_TRACKER_H_
