#ifndef WALKGRAPH_DATA_SIMULATOR_PHONE_H_
#define WALKGRAPH_DATA_SIMULATOR_PHONE_H_

#include <Eigen/Geometry>
#include <vector>

#include "data/recording.h"
#include "data/simulator/handling.h"
#include "data/simulator/motion.h"
#include "data/simulator/random.h"
#include "data/simulator/settings.h"

namespace walkgraph {

// Attitudes of a phone that is held flat in front of a walking person, one per state: device to
// building axes (x, y of the frame, z up); device y points forward.
std::vector<Eigen::Quaterniond> SimulateAttitudes(const std::vector<WalkState>& states,
                                                  const Gait& gait, const HoldSettings& settings,
                                                  const Handling& handling, Random* random);

// Fills specific force and angular rate of `recording`, device axes, one sample per state.
void SimulateInertial(const std::vector<WalkState>& states,
                      const std::vector<Eigen::Quaterniond>& attitudes, const Gait& gait,
                      const SimulationSettings& settings, const Handling& handling, Random* random,
                      Recording* recording);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_PHONE_H_
