#ifndef WALKGRAPH_EVAL_CLI_SIMULATION_KEYS_H_
#define WALKGRAPH_EVAL_CLI_SIMULATION_KEYS_H_

#include <string>
#include <vector>

#include "data/simulator/settings.h"
#include "eval/config_keys.h"

namespace walkgraph {

// All keys of the simulator's settings, "barometer.noise_hpa", in order.
std::vector<ConfigKey> SimulationKeys(SimulationSettings* settings);

// Sets one key. Throws UsageError, naming `flag`, for an unknown key or a value of the wrong kind
// or out of range.
void AssignSimulationKey(const std::string& key, const std::string& value, const std::string& flag,
                         SimulationSettings* settings);

// The settings as documented YAML.
std::string PrintSimulationSettings(const SimulationSettings& settings);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_CLI_SIMULATION_KEYS_H_
