#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_MAGNETIC_TRAINER_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_MAGNETIC_TRAINER_H_

#include <vector>

#include "frontends/radio_map/magnetic_map.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// The magnetic map of every floor where at least three survey trials (see SurveyScan) measured the
// field, from Site::magnetic. Mean and variance at a place are those of the samples under a
// Gaussian kernel and of a pseudo-sample of the whole floor. The kernel's bandwidth and the
// pseudo-sample's weight have the greatest log density of samples whose trial is left out; the
// spread is then scaled to the residuals of those, and their integrated autocorrelation along the
// walks is the map's correlation time.
std::vector<MagneticMap> TrainMagneticMaps(const Site& site);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_MAGNETIC_TRAINER_H_
