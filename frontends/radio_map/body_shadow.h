#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_BODY_SHADOW_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_BODY_SHADOW_H_

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <vector>

#include "frontends/radio_map/map_builder.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// Who holds a phone shields it from what lies behind: a reading taken while facing the direction
// h is a h . t(x) dB stronger than the mean over all directions, t the direction of the transmitter
// and a the shadow's amplitude, half of what front and back differ by (up to 9 dB: Kaemarungsi and
// Krishnamurthy, MobiQuitous 2004). The field's own slope does not tell that direction: walls and
// shadowing bend it.

// Where the transmitters of one radio on one floor seem to stand: the mean place of their readings,
// weighted by the power received.
std::map<std::uint32_t, Eigen::Vector2d> LocateSources(const ScanList& scans);

// Sets the shadow_db of all readings of scans of one radio.
void SetBodyShadows(double amplitude_db, std::vector<SurveyScan>* scans);

// The same as a map has it, of a scan of its floor and radio; zero for transmitters unknown to it.
void SetBodyShadow(const RadioMap& map, SurveyScan* scan);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_BODY_SHADOW_H_
