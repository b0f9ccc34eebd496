#ifndef WALKGRAPH_FACTORS_RSSI_OFFSET_H_
#define WALKGRAPH_FACTORS_RSSI_OFFSET_H_

#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// What is known beforehand of the RSSI offset b of a walk, which stands in the residual of a
// reading z as z + b - mean: a phone that hears louder than the map's fields has a negative one.
struct RssiOffsetPrior {
  double mean_db = 0;
  double sigma_db = 0;  // 0 where b is not free
};

// From the survey's walks with a phone of the same model, or the settings where it does not tell.
// Held at the mean where the state is fixed, 0 where it is absent.
RssiOffsetPrior PriorOfRssiOffset(const Site& site, const Evidence& evidence, Radio radio,
                                  const RssiOffsetSettings& settings);

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_RSSI_OFFSET_H_
