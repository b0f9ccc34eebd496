#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_SWEEPS_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_SWEEPS_H_

#include <cstddef>
#include <vector>

#include "frontends/evidence/evidence.h"

namespace walkgraph {

// The readings of one radio that one sweep of the phone brought: for Wi-Fi what was printed
// together, for beacons, which report one by one, what was printed within the same second of the
// clock.
struct Sweep {
  TimeNs mean_heard_ns = 0;
  std::vector<std::size_t> readings;  // indices into Evidence::readings, by time heard
};

// Sweeps of a radio in order of their mean time heard; each reading is in exactly one.
std::vector<Sweep> GroupSweeps(const Evidence& evidence, Radio radio);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_SWEEPS_H_
