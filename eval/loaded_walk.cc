#include "eval/loaded_walk.h"

#include <glog/logging.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <utility>

#include "data/input_error.h"
#include "eval/files.h"
#include "frontends/build_evidence.h"

namespace walkgraph {
namespace {

bool ChangesFloors(const Truth& truth) {
  return std::any_of(truth.waypoints.begin(), truth.waypoints.end(),
                     [&](const Waypoint& w) { return w.floor != truth.waypoints.front().floor; });
}

// Of the folder or, failing that, of the truth.
std::optional<int> GivenFloor(const WalkFile& file, const Truth& truth) {
  if (file.floor || truth.waypoints.empty()) return file.floor;
  return truth.waypoints.front().floor;
}

}  // namespace

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
  if (floor_given && ChangesFloors(loaded.truth)) {
    loaded.notes.emplace_back("changes floors, so that none is given: estimated");
  } else if (floor_given) {
    loaded.evidence.floor = GivenFloor(file, loaded.truth);
  }
  return loaded;
}

void LogNotes(const std::vector<LoadedWalk>& walks) {
  const auto noted = [](const LoadedWalk& walk) { return !walk.notes.empty(); };
  const auto first = std::find_if(walks.begin(), walks.end(), noted);
  if (first == walks.end()) return;
  LOG(WARNING) << std::count_if(first, walks.end(), noted) << " of " << walks.size() << " walks, "
               << first->file.id << " the first: " << first->notes.front();
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
