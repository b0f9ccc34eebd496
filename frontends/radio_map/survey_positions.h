#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_SURVEY_POSITIONS_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_SURVEY_POSITIONS_H_

#include "data/trajectory.h"
#include "data/truth.h"
#include "frontends/evidence/evidence.h"

namespace walkgraph {

// Where the person was between surveyed waypoints: on the straight line from one to the next, as
// far along as the share of the leg's detected steps says (of its time, where a leg has no steps).
// A pose at every waypoint, step end and second. The sigma is a waypoint's own at the waypoints and
// grows towards the middle of a leg as a Brownian bridge does. `truth` must be in the building
// frame; no waypoints give an empty trajectory, before the first and after the last waypoint
// nothing is said.
Trajectory SurveyTrajectory(const Truth& truth, const Evidence& evidence);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_SURVEY_POSITIONS_H_
