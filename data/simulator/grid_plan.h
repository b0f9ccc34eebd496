#ifndef WALKGRAPH_DATA_SIMULATOR_GRID_PLAN_H_
#define WALKGRAPH_DATA_SIMULATOR_GRID_PLAN_H_

#include <string>

#include "data/building.h"
#include "data/simulator/plan.h"
#include "data/simulator/settings.h"

namespace walkgraph {

// The open hall of DSFF: one floor of 18 m by 36 m without walls inside. People walk at random:
// from node to node of a grid, scattered around them. Throws InputError where its spacing is too
// wide.
Plan MakeHall(const BuildingSettings& settings);

// A building as a file describes it. Walls are the edges of its outlines and obstacles; ways run
// along a grid of what is inside and free, the largest connected part of each floor; connectors
// join the nodes nearest to their stops. Throws InputError (naming `path`) where a floor has no
// room to walk or a connector names a floor that does not exist.
Plan MakeGivenPlan(const Building& building, const BuildingSettings& settings,
                   const GaitSettings& gait, const std::string& path);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_GRID_PLAN_H_
