#ifndef WALKGRAPH_DATA_SIMULATOR_SIMULATED_WALK_H_
#define WALKGRAPH_DATA_SIMULATOR_SIMULATED_WALK_H_

#include <string>
#include <vector>

#include "data/recording.h"
#include "data/simulator/motion.h"
#include "data/truth.h"

namespace walkgraph {

// A simulated walk with everything that is true about it.
struct SimulatedWalk {
  std::string name;  // path below the data set, "survey/walk_01"
  Recording recording;
  Truth truth;                  // at the start, the end, every turn and at least every 10 s
  std::vector<WalkState> path;  // where the person really was, at the rate of the IMU
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_SIMULATED_WALK_H_
