#ifndef WALKGRAPH_EVAL_SETTINGS_H_
#define WALKGRAPH_EVAL_SETTINGS_H_

#include "factors/settings.h"

namespace walkgraph {

// Everything that can be configured, made of the settings structs of the layers below. The defaults
// are the documented reference that `walkgraph config` prints.
struct Settings {
  FactorSettings factors;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_SETTINGS_H_
