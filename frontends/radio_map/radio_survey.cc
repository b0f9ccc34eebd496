#include "frontends/radio_map/radio_survey.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace walkgraph {

std::vector<SurveyScan> RadioSurvey::Scans(double lag_s, const LagRange& placed) const {
  std::vector<SurveyScan> scans;
  for (std::size_t w = 0; w < walks.size(); ++w) {
    if (walks[w].trajectory.empty()) continue;
    std::vector<SurveyScan> of_walk = PlaceScans(walks, w, radio, site_index[w], lag_s, placed);
    std::move(of_walk.begin(), of_walk.end(), std::back_inserter(scans));
  }
  return scans;
}

FloorSurvey RadioSurvey::OfFloor(const std::vector<SurveyScan>& scans, int floor) const {
  return SurveyOfFloor(building, path, scans, floor, radio, settings);
}

}  // namespace walkgraph
