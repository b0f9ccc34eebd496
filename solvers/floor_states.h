#ifndef WALKGRAPH_SOLVERS_FLOOR_STATES_H_
#define WALKGRAPH_SOLVERS_FLOOR_STATES_H_

#include <vector>

#include "solvers/baselines/floor_tracker.h"
#include "solvers/estimator.h"

namespace walkgraph {

// The posterior of each floor, "floor_-1_probability", where the track had a choice: a row whenever
// it has changed by more than a hundredth, without sigma (zero).
void AppendFloorStates(const FloorTrack& track, std::vector<SlowStateEstimate>* states);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_FLOOR_STATES_H_
