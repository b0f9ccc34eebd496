#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_RADIO_SURVEY_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_RADIO_SURVEY_H_

#include <cstdint>
#include <vector>

#include "frontends/radio_map/map_builder.h"
#include "frontends/radio_map/site.h"
#include "frontends/radio_map/survey_scans.h"
#include "frontends/radio_map/trainer.h"

namespace walkgraph {

// What one radio heard on the survey, to be placed with one lag after another. All that it refers
// to must outlive it.
struct RadioSurvey {
  const Building& building;
  const std::vector<SurveyWalk>& walks;
  const std::vector<std::vector<std::int32_t>>& site_index;  // as in PlaceScans, by walk
  const std::vector<SurveyPoint>& path;
  Radio radio = Radio::kWifi;
  const TrainerSettings& settings;

  // By walk, then time. The arguments are those of PlaceScans.
  std::vector<SurveyScan> Scans(double lag_s, const LagRange& placed) const;
  // Those of them on one floor. They must outlive it.
  FloorSurvey OfFloor(const std::vector<SurveyScan>& scans, int floor) const;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_RADIO_SURVEY_H_
