#ifndef WALKGRAPH_DATA_SIMULATOR_ITINERARY_H_
#define WALKGRAPH_DATA_SIMULATOR_ITINERARY_H_

#include <vector>

#include "data/simulator/motion.h"
#include "data/simulator/plan.h"
#include "data/simulator/random.h"
#include "data/simulator/settings.h"

namespace walkgraph {

// The links that a walk can begin on: corridors that lead to no cabin.
std::vector<int> CorridorLinks(const Plan& plan);

// A random tour over the ways of a plan that takes about `duration_s`, begun on a link and never
// turning back but in dead ends.
std::vector<Leg> RandomTour(const Plan& plan, int first_link, const Gait& gait,
                            const SimulationSettings& settings, double duration_s, Random* random);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_ITINERARY_H_
