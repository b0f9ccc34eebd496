#ifndef WALKGRAPH_GRAPH_CHECK_SETTINGS_H_
#define WALKGRAPH_GRAPH_CHECK_SETTINGS_H_

#include "factors/settings.h"

namespace walkgraph {

// Throws std::invalid_argument, naming the setting, where a sigma, rate, spacing or time constant
// that the graph divides by is not positive and finite.
void CheckSettings(const FactorSettings& settings);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_CHECK_SETTINGS_H_
