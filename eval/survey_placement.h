#ifndef WALKGRAPH_EVAL_SURVEY_PLACEMENT_H_
#define WALKGRAPH_EVAL_SURVEY_PLACEMENT_H_

#include <string>
#include <vector>

#include "data/building.h"
#include "data/trajectory.h"
#include "data/truth.h"
#include "eval/metrics.h"
#include "eval/settings.h"
#include "frontends/evidence/evidence.h"

namespace walkgraph {

// Where a survey walk was.
struct SurveyPlacement {
  Trajectory trajectory;
  bool fell_back = false;  // the smoother was asked for, had no answer, and walked distance has
};

// Places a walk between its waypoints (in the building frame) as settings.survey.positions says.
SurveyPlacement PlaceSurveyWalk(const Building& building, const Truth& truth,
                                const Evidence& evidence, const Settings& settings);

// Places a walk without every second of its inner waypoints and returns the errors at these; none
// for walks of under three waypoints.
std::vector<WaypointError> LeftOutErrors(const Building& building, const Truth& truth,
                                         const Evidence& evidence, const Settings& settings);

// The left-out errors of one way of placing all walks of a data set.
struct LeftOutRow {
  std::string positions;
  std::vector<WaypointError> errors;
};

// A table for people with a row each: number, mean, median, 90th percentile, coverage.
std::string FormatLeftOut(const std::vector<LeftOutRow>& rows);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_SURVEY_PLACEMENT_H_
