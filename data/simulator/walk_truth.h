#ifndef WALKGRAPH_DATA_SIMULATOR_WALK_TRUTH_H_
#define WALKGRAPH_DATA_SIMULATOR_WALK_TRUTH_H_

#include <vector>

#include "data/simulator/motion.h"
#include "data/simulator/plan.h"
#include "data/truth.h"

namespace walkgraph {

// A waypoint at `first_ns`, where the person turns and arrives, and between them so that none is
// further than `every_s` from the one before. Between floors there is none: they come as soon as a
// floor is reached.
Truth MakeTruth(const Plan& plan, const std::vector<Leg>& legs,
                const std::vector<WalkState>& states, TimeNs first_ns, double every_s);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_WALK_TRUTH_H_
