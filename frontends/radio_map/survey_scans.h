#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_SURVEY_SCANS_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_SURVEY_SCANS_H_

#include <cstdint>
#include <vector>

#include "frontends/radio_map/site.h"
#include "frontends/radio_map/trainer.h"

namespace walkgraph {

// Lags (s) at which a reading must be within a second of the span of known positions to take part.
struct LagRange {
  double first_s = 0;
  double last_s = 0;
};

// Index of the first walk of the same trial: the walk's own where it belongs to none.
std::uint32_t FirstOfTrial(const std::vector<SurveyWalk>& walks, std::size_t index);

// The unique readings of a survey walk's scans of one radio, each where the person was `lag_s`
// after it was stamped (see Site::reading_lag_s). `placed` is {lag_s, lag_s}, or wider where
// different lags are to be compared on the same readings. `index` is the walk's,
// `site_index` the site's transmitter of each of the evidence's. Precondition: the trajectory is
// not empty.
std::vector<SurveyScan> PlaceScans(const std::vector<SurveyWalk>& walks, std::size_t index,
                                   Radio radio, const std::vector<std::int32_t>& site_index,
                                   double lag_s, const LagRange& placed);

// Mean of the places of a scan's readings.
Eigen::Vector2d MeanPosition(const SurveyScan& scan);

// The first number that no survey walk of the site has.
std::uint32_t NextWalk(const Site& site);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_SURVEY_SCANS_H_
