#include "solvers/floors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "factors/cost.h"
#include "frontends/radio_map/sweeps.h"

namespace walkgraph {
namespace {

constexpr double kChanceOfUnknown = 0.01;
constexpr double kSpreadOfUnknownDb = 10.0;

}  // namespace

std::vector<int> CandidateFloors(const Site& site, const Evidence& evidence) {
  if (evidence.floor) return {*evidence.floor};
  std::vector<int> floors = site.SurveyedFloors();
  if (floors.empty() && !site.building.floors.empty()) {
    floors.push_back(site.building.floors.front().number);
  }
  if (floors.empty()) floors.push_back(0);
  return floors;
}

double UnknownReadingsCost(const Site& site, const Evidence& evidence,
                           const FingerprintSettings& settings, int floor) {
  const std::vector<std::int32_t> site_index = MatchTransmitters(site, evidence);
  const double nats_each =
      0.5 - std::log(kChanceOfUnknown) + GaussianLogNormaliser(kSpreadOfUnknownDb);
  double nats = 0;
  for (const Radio radio : {Radio::kWifi, Radio::kBeacon}) {
    if (!(radio == Radio::kWifi ? settings.wifi : settings.beacon)) continue;
    const RadioMap* map = site.FindMap(floor, radio);
    for (const Sweep& sweep : GroupSweeps(evidence, radio)) {
      int unknown = 0, count = 0;
      for (const std::size_t i : sweep.readings) {
        const std::int32_t transmitter = site_index[evidence.readings[i].transmitter];
        if (transmitter == kUnknownTransmitter) continue;
        ++count;
        if (map == nullptr || map->FindField(static_cast<std::uint32_t>(transmitter)) < 0) {
          ++unknown;
        }
      }
      if (unknown == 0) continue;
      const double n_eff = settings.n_eff > 0 ? settings.n_eff : map == nullptr ? 0.0 : map->n_eff;
      nats += nats_each * unknown * (n_eff > 0 ? std::min(1.0, n_eff / count) : 1.0);
    }
  }
  return nats;
}

double HeightOfFloor(const Site& site, int floor) {
  const Floor* found = site.building.FindFloor(floor);
  return found == nullptr ? 0.0 : found->height_m;
}

}  // namespace walkgraph
