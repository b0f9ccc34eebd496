#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_DIRECTION_BIAS_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_DIRECTION_BIAS_H_

#include "frontends/radio_map/executor.h"
#include "frontends/radio_map/radio_survey.h"

namespace walkgraph {

// What makes one radio's readings depend on the way somebody walks: who comes from the other side
// reads differently at the same place.
struct DirectionBias {
  double lag_s = 0;           // see Site::reading_lag_s
  double body_shadow_db = 0;  // see body_shadow.h
};

// Both together, by least squares on what survey walks read beside maps that they were held out of,
// placed as stamped: a lag goes with the field's slope along the way, a shadow with the bearing of
// the transmitter. Shrunk towards none (give or take 1 s, as clocks of one phone agree, and 3 dB)
// as the scatter over trials says. Where the survey walked mostly one way the maps hide a part of
// either, and what is found is too small. The lag is within -0.75 and 2.25 s, the shadow not
// negative; what the settings switch off stays 0, and both do where no floor has six walks of three
// trials.
DirectionBias CalibrateDirectionBias(const RadioSurvey& survey, const Executor& run = RunInOrder);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_DIRECTION_BIAS_H_
