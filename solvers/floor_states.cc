#include "solvers/floor_states.h"

#include <cmath>
#include <cstddef>
#include <string>

namespace walkgraph {

void AppendFloorStates(const FloorTrack& track, std::vector<SlowStateEstimate>* states) {
  constexpr double kChange = 0.01;
  if (track.floors.size() < 2) return;
  for (std::size_t f = 0; f < track.floors.size(); ++f) {
    const std::string name = "floor_" + std::to_string(track.floors[f]) + "_probability";
    double written = -1;
    for (std::size_t k = 0; k < track.time_ns.size(); ++k) {
      const double p =
          track.probability(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(f));
      if (std::abs(p - written) < kChange) continue;
      states->push_back({name, track.time_ns[k], p, 0.0});
      written = p;
    }
  }
}

}  // namespace walkgraph
