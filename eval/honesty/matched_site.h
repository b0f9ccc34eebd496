#ifndef WALKGRAPH_EVAL_HONESTY_MATCHED_SITE_H_
#define WALKGRAPH_EVAL_HONESTY_MATCHED_SITE_H_

#include "data/simulator/random.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// A hall of 90 m by 90 m about the origin whose radio map is drawn, not trained: path loss with a
// smooth random field on top, a spread that varies from place to place, and the probability of
// hearing that belongs to such means. The map is what radio waves do there, so that readings drawn
// from it are those that the fingerprint and hearing factors expect. `map_error_sigma_m` becomes
// the map's.
Site MakeMatchedSite(double map_error_sigma_m, const Random& random);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_HONESTY_MATCHED_SITE_H_
