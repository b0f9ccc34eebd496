#ifndef WALKGRAPH_DATA_SIMULATOR_BAROMETER_H_
#define WALKGRAPH_DATA_SIMULATOR_BAROMETER_H_

#include <vector>

#include "data/recording.h"
#include "data/simulator/motion.h"
#include "data/simulator/random.h"
#include "data/simulator/settings.h"

namespace walkgraph {

// Fills the pressure of `recording`: the standard atmosphere around the person's height, made
// warmer, and everything that `settings` puts on top of it.
void SimulateBarometer(const std::vector<WalkState>& states, const BarometerSettings& settings,
                       Random* random, Recording* recording);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_BAROMETER_H_
