#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_MAP_CALIBRATION_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_MAP_CALIBRATION_H_

#include "frontends/radio_map/map_builder.h"

namespace walkgraph {

struct MapCalibration {
  double n_eff = 3;              // independent readings per scan
  double map_error_sigma_m = 2;  // of the error that the scans of some 20 s share, per axis
};

// How far the likelihood of a map may be believed, from survey walks that the map was not trained
// on (three folds of walks). Each held-out walk is cut into pieces of 20 s; a piece's readings,
// moved together by an unknown shift, give a posterior of that shift, whose density at zero, the
// truth, is the score: once for every scan alone and once for the piece, blurred by the map error.
// The pair of n_eff and map error with the best total score is chosen. A proper score: neither too
// bold nor too timid a likelihood wins. The defaults where there are fewer than six walks.
MapCalibration CalibrateMap(int floor, Radio radio, const FieldGrid& grid, const ScanList& scans,
                            const FieldModel& model, const TrainerSettings& settings);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_MAP_CALIBRATION_H_
