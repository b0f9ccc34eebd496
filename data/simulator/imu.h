#ifndef WALKGRAPH_DATA_SIMULATOR_IMU_H_
#define WALKGRAPH_DATA_SIMULATOR_IMU_H_

#include <vector>

#include "data/recording.h"
#include "data/simulator/motion.h"
#include "data/simulator/random.h"

namespace walkgraph {

// What a phone that is held flat in front of a walking person measures, device axes: specific force
// and angular rate at the rate of the states, rotation vector and magnetic field at a tenth of that
// (5 Hz from 50 Hz states), pressure once a second. Building x is magnetic east. Fills the streams
// of `recording`.
void SimulateImu(const std::vector<WalkState>& states, const Gait& gait, Random* random,
                 Recording* recording);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_IMU_H_
