#include "eval/loaded_walk.h"

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "data/input_error.h"
#include "eval/files.h"
#include "frontends/build_evidence.h"

namespace walkgraph {

LoadedWalk LoadWalk(const WalkFile& file, const Building& building,
                    const FrontendSettings& settings, bool floor_given) {
  LoadedWalk loaded;
  loaded.file = file;
  try {
    loaded.checksum = FileChecksum(file.path);
    const Walk walk = ReadWalk(file, settings.reader);
    loaded.truth = ToBuildingFrame(walk.truth, building);
    loaded.evidence = BuildEvidence(walk.recording, settings);
    loaded.evidence.id = file.id;
  } catch (const std::exception& error) {
    loaded.error = error.what();
    return loaded;
  }
  if (floor_given) {
    loaded.evidence.floor = file.floor;
    if (!file.floor && !loaded.truth.waypoints.empty()) {
      loaded.evidence.floor = loaded.truth.waypoints.front().floor;
    }
  }
  return loaded;
}

void UseWaypointsAsAnchors(int every, double sigma_m, LoadedWalk* walk) {
  std::vector<Waypoint> scored;
  for (std::size_t i = 0; i < walk->truth.waypoints.size(); ++i) {
    const Waypoint& waypoint = walk->truth.waypoints[i];
    if (i % static_cast<std::size_t>(every) == 0) {
      walk->evidence.anchors.push_back(
          {waypoint.time_ns, waypoint.position, waypoint.floor, sigma_m});
    } else {
      scored.push_back(waypoint);
    }
  }
  walk->truth.waypoints = std::move(scored);
}

}  // namespace walkgraph
