#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_MAP_CALIBRATION_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_MAP_CALIBRATION_H_

#include "frontends/radio_map/map_builder.h"

namespace walkgraph {

// How sharply a map's likelihood should be drawn and how far it may be believed, from survey walks
// that the map was not trained on. Each held-out walk is cut into pieces of 20 s; a piece's
// readings, moved together by an unknown shift, give a posterior of that shift, whose density at
// zero, the truth, is the score: once for every scan alone and once for the piece, blurred by the
// map error. A proper score: neither too bold nor too timid a likelihood wins. (The density of
// left-out RSSI itself would choose far smoother fields, which place worse: it does not see that
// errors are shared.)

struct MapCalibration {
  double n_eff = 3;               // independent readings per scan
  double hear_weight = 0.5;       // see RadioMap
  double map_error_sigma_m = 2;   // of the error that the scans of some 20 s share, per axis
  double map_error_growth = 0.5;  // metres of it per metre from the survey
};

// Length scale, noise and hearing bandwidth by climbing fixed ladders on one third of the walks,
// with a selection of the transmitters; then the scale that makes left-out residuals honest. The
// default model where there are fewer than six walks.
FieldModel SelectFieldModel(const FloorSurvey& survey, const TrainerSettings& settings,
                            const Executor& run = RunInOrder);

// n_eff, map error and its growth by what three folds of walks say of them: the posterior mean over
// a grid, beside a prior of the defaults within a factor of two each; hear_weight by the best total
// score. The defaults where there are fewer than six walks.
MapCalibration CalibrateMap(const FloorSurvey& survey, const FieldModel& model,
                            const TrainerSettings& settings, const Executor& run = RunInOrder);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_MAP_CALIBRATION_H_
