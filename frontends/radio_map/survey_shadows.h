#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_SURVEY_SHADOWS_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_SURVEY_SHADOWS_H_

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <vector>

#include "frontends/radio_map/map_builder.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// Where the transmitters of one radio on one floor seem to stand: the mean place of their readings,
// weighted by the power received.
std::map<std::uint32_t, Eigen::Vector2d> LocateSources(
    const ScanList& scans, const TransmitterSelection& transmitters = {});

// Sets the shadow_db (see body_shadow.h) of all readings of scans of one radio.
void SetBodyShadows(double amplitude_db, std::vector<SurveyScan>* scans);

// The same as a map has it, of a scan of its floor and radio; zero for transmitters unknown to it.
void SetBodyShadow(const RadioMap& map, SurveyScan* scan);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_SURVEY_SHADOWS_H_
