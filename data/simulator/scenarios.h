#ifndef WALKGRAPH_DATA_SIMULATOR_SCENARIOS_H_
#define WALKGRAPH_DATA_SIMULATOR_SCENARIOS_H_

#include <optional>
#include <string>
#include <vector>

#include "data/simulator/settings.h"

namespace walkgraph {

// The sample that lies in the source tree: one floor, 50 Hz, no barometric disturbance.
SimulationSettings SampleSettings();

// A house of several floors with nothing wrong: white sensor noise, readings that scatter, and
// walls, floors and shadows that a survey can learn; no bias, offset, drift, latency or change.
SimulationSettings CleanSettings();

// Scenario names beside `sample`:
//   office          the defaults: everything that recorded walks show
//   hall            the same in an open hall of 18 m by 36 m
//   clean           CleanSettings()
//   gyro_bias       clean, and the gyroscope's bias and its random walk
//   heading_offset  clean, and the phone past the walking direction, magnetic errors
//   step_scale      clean, and persons whose steps are longer or shorter than they seem
//   baro_offset     clean, and barometer offset, weather and its drift
//   map_change      clean, and transmitters that vanish or change power after the survey
const std::vector<std::string>& ScenarioNames();

// The settings of a scenario above; nullopt for another name.
std::optional<SimulationSettings> ScenarioSettings(const std::string& name);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_SCENARIOS_H_
