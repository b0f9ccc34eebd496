#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_BAROMETRIC_HISTORY_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_BAROMETRIC_HISTORY_H_

#include <optional>
#include <vector>

#include "data/building.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"
#include "frontends/radio_map/trainer.h"

namespace walkgraph {

// The median of height by the barometer minus height of the floor over a survey walk. None without
// barometer, device or Unix time, or where the building knows no heights.
std::optional<SurveyedOffset> MeasureBarometricOffset(const Building& building,
                                                      const SurveyWalk& walk);

struct OffsetPrior {
  double mean_m = 0;
  double sigma_m = 0;
};

// What the survey makes of a walk's offset at its begin: of the walks with a phone of the same
// model the one whose offset says most, after drifting by a random walk from then to now or back.
// Its sigma is widened by how far those walks miss what they predict of one another. None where
// there is none.
std::optional<OffsetPrior> PriorOfOffset(const std::vector<SurveyedOffset>& history,
                                         const Evidence& evidence, double walk_m_per_sqrt_s);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_BAROMETRIC_HISTORY_H_
