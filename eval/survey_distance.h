#ifndef WALKGRAPH_EVAL_SURVEY_DISTANCE_H_
#define WALKGRAPH_EVAL_SURVEY_DISTANCE_H_

#include <Eigen/Core>
#include <optional>

#include "data/truth.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// A walk nearer than this to the survey counts as covered: beyond it nobody could know the place.
inline constexpr double kCoveredDistanceM = 3.0;

// Mean horizontal distance (m) from a walk's waypoints to the nearest survey path of their floor.
// A waypoint on a floor without survey makes it infinite; no waypoints make it NaN. The truth is in
// the building frame.
double SurveyDistance(const Site& site, const Truth& truth);

// The mean of the surveyed points of a floor: where a walk that no method placed is scored. nullopt
// where the floor was not surveyed.
std::optional<Eigen::Vector2d> SurveyMean(const Site& site, int floor);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_SURVEY_DISTANCE_H_
