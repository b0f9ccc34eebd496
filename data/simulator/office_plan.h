#ifndef WALKGRAPH_DATA_SIMULATOR_OFFICE_PLAN_H_
#define WALKGRAPH_DATA_SIMULATOR_OFFICE_PLAN_H_

#include "data/simulator/plan.h"
#include "data/simulator/random.h"
#include "data/simulator/settings.h"

namespace walkgraph {

// The floor of the sample: offices on 44 m by 24 m, two corridors along x, joined by three along y,
// rooms around and between them.
Plan MakeSampleOffice();

// A house of such floors, 46-60 m by 24-29 m, with two stairwells, a lift and an escalator between
// the corridors. Node heights follow `settings`; the shape is drawn from `random`.
Plan MakeOffice(const BuildingSettings& settings, const GaitSettings& gait, Random* random);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_OFFICE_PLAN_H_
