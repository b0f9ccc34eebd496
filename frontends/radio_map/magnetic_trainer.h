#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_MAGNETIC_TRAINER_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_MAGNETIC_TRAINER_H_

#include <vector>

#include "frontends/radio_map/magnetic_map.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// The magnetic map of every floor where at least six survey trials (see SurveyScan) measured the
// field for 20 s, from Site::magnetic. A kernel estimate whose bandwidth has the greatest log
// density of samples whose trial is left out, and whose spread is scaled to their residuals. The
// correlation time and the map error, as those of a radio map (see map_calibration.h), place pieces
// of held-out survey walks best: autocorrelation of the residuals would not see that a map drawn a
// metre beside is wrong everywhere in another way.
std::vector<MagneticMap> TrainMagneticMaps(const Site& site);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_MAGNETIC_TRAINER_H_
