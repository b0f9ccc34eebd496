#ifndef WALKGRAPH_SOLVERS_FLOORS_H_
#define WALKGRAPH_SOLVERS_FLOORS_H_

#include <vector>

#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// The floors a walk may be on: the given one, else those with a radio map, else the building's
// first, else 0. Never empty.
std::vector<int> CandidateFloors(const Site& site, const Evidence& evidence);

// What the readings cost that the site knows but the floor does not, nats: without it a floor that
// knows little would explain a walk best. Each counts as heard with one chance in a hundred (our
// choice) and as strong as anything, with its scan's weight.
double UnknownReadingsCost(const Site& site, const Evidence& evidence,
                           const FingerprintSettings& settings, int floor);

// Height of a floor above the building's datum; 0 where the building does not know it.
double HeightOfFloor(const Site& site, int floor);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_FLOORS_H_
