#include "frontends/radio_map/site.h"

#include <algorithm>
#include <set>

namespace walkgraph {

const RadioMap* Site::FindMap(int floor, Radio radio) const {
  for (const RadioMap& map : maps) {
    if (map.floor == floor && map.radio == radio) return &map;
  }
  return nullptr;
}

const DeviceLoudness* Site::FindLoudness(const std::string& device, Radio radio) const {
  const auto found = std::find_if(loudness.begin(), loudness.end(), [&](const DeviceLoudness& l) {
    return l.device == device && l.radio == radio;
  });
  return found == loudness.end() ? nullptr : &*found;
}

const MagneticMap* Site::FindMagneticMap(int floor) const {
  const auto found = std::find_if(magnetic_maps.begin(), magnetic_maps.end(),
                                  [floor](const MagneticMap& map) { return map.floor == floor; });
  return found == magnetic_maps.end() ? nullptr : &*found;
}

std::vector<int> Site::SurveyedFloors() const {
  std::set<int> floors;
  for (const RadioMap& map : maps) floors.insert(map.floor);
  return {floors.begin(), floors.end()};
}

double Site::HeadingToBuilding() const {
  return building.origin ? -building.origin->rotation_rad : 0.0;
}

std::vector<std::int32_t> MatchTransmitters(const Site& site, const Evidence& evidence) {
  std::vector<std::int32_t> index;
  index.reserve(evidence.transmitters.size());
  for (const Transmitter& transmitter : evidence.transmitters) {
    const auto it =
        std::lower_bound(site.transmitters.begin(), site.transmitters.end(), transmitter);
    const bool known = it != site.transmitters.end() && *it == transmitter;
    index.push_back(known ? static_cast<std::int32_t>(it - site.transmitters.begin())
                          : kUnknownTransmitter);
  }
  return index;
}

}  // namespace walkgraph
