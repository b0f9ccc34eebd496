#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_READING_LAG_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_READING_LAG_H_

#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// The evidence with every reading later by the site's lag, its printing too: its age is the phone's
// own.
Evidence AlignReadings(const Site& site, Evidence evidence);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_READING_LAG_H_
