#include "frontends/radio_map/radio_survey.h"

#include <map>
#include <utility>

#include "frontends/radio_map/body_shadow.h"

namespace walkgraph {

std::vector<SurveyScan> RadioSurvey::Scans(double lag_s, const LagRange& placed,
                                           double body_shadow_db) const {
  std::vector<SurveyScan> scans;
  for (std::size_t w = 0; w < walks.size(); ++w) {
    if (walks[w].trajectory.empty()) continue;
    for (SurveyScan& scan : PlaceScans(walks, w, radio, site_index[w], lag_s, placed)) {
      scans.push_back(std::move(scan));
    }
  }
  SetBodyShadows(body_shadow_db, &scans);
  return scans;
}

PlacedSurvey RadioSurvey::Place(double lag_s, const LagRange& placed, double body_shadow_db) const {
  PlacedSurvey survey{Scans(lag_s, placed, body_shadow_db), {}};
  std::map<int, ScanList> by_floor;
  for (const SurveyScan& scan : survey.scans) by_floor[scan.floor].push_back(&scan);
  for (auto& [floor, scans] : by_floor) {
    const FieldGrid grid = CoveringGrid(building.FindFloor(floor), path, floor, settings);
    survey.floors.push_back({floor, radio, grid, std::move(scans)});
  }
  return survey;
}

}  // namespace walkgraph
