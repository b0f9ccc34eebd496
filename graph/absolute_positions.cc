#include "graph/absolute_positions.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "factors/at_time.h"
#include "factors/fingerprint.h"
#include "factors/magnetic.h"
#include "factors/map_look.h"
#include "factors/map_sweeps.h"
#include "factors/prior.h"
#include "graph/map_error_states.h"
#include "graph/node_times.h"
#include "graph/slow_states.h"

namespace walkgraph {
namespace {

// Readings heard within this time share one place, and with it one look at the map: a fifth of a
// metre of walking.
constexpr double kSamePlaceS = 0.2;

// Adds a factor whose first block is the position at a time, which the factor itself leaves out:
// the node's where one stands there, else AtTime's between two.
void AddAtTime(GraphFactor factor, TimeNs time_ns, const std::vector<int>& other_blocks,
               TimeNs arrival_ns, WalkGraph* walk) {
  const NodeBracket bracket = FindBracket(walk->node_ns, time_ns);
  const auto before = static_cast<std::size_t>(bracket.before);
  factor.blocks = {walk->position[before]};
  if (bracket.fraction > 0) {
    factor.cost = std::make_unique<AtTime<>>(bracket.fraction, std::move(factor.cost));
    factor.blocks.push_back(walk->position[before + 1]);
  }
  factor.blocks.insert(factor.blocks.end(), other_blocks.begin(), other_blocks.end());
  factor.reading = true;
  factor.arrival_ns = arrival_ns;
  walk->graph.AddFactor(std::move(factor));
}

// The heading of the nearest node: half a node's turn moves a shadow by less than it is known.
int HeadingNear(const WalkGraph& walk, TimeNs time_ns) {
  const NodeBracket bracket = FindBracket(walk.node_ns, time_ns);
  return walk.heading[static_cast<std::size_t>(bracket.before + (bracket.fraction > 0.5 ? 1 : 0))];
}

// The same for one that tells where the walk is.
void AddPositionAtTime(GraphFactor factor, TimeNs time_ns, const std::vector<int>& other_blocks,
                       TimeNs arrival_ns, WalkGraph* walk) {
  factor.absolute_position = true;
  AddAtTime(std::move(factor), time_ns, other_blocks, arrival_ns, walk);
  if (!walk->first_absolute_position_ns || arrival_ns < *walk->first_absolute_position_ns) {
    walk->first_absolute_position_ns = arrival_ns;
  }
}

GraphFactor MakeFingerprint(const RadioMap& map, MapSweep part, const LossSettings& loss,
                            double growth_per_sigma) {
  auto cost = std::make_unique<FingerprintFactor>(&map, std::move(part), loss, growth_per_sigma);
  GraphFactor factor;
  factor.type = FingerprintFactor::kName;
  factor.log_normaliser = cost->LogNormaliser() - cost->CostConstant();
  factor.whitened_rows = cost->readings();
  factor.weight = cost->weight();
  factor.row_loss = loss;
  factor.cost = std::move(cost);
  return factor;
}

GraphFactor MakeHearing(const RadioMap& map, MapSweep scan, double growth_per_sigma) {
  auto cost = std::make_unique<HearingFactor>(&map, std::move(scan), growth_per_sigma);
  GraphFactor factor;
  factor.type = HearingFactor::kName;
  factor.log_normaliser = -cost->CostConstant();
  factor.weight = cost->weight();
  factor.cost = std::move(cost);
  return factor;
}

// A radio whose readings take part, on one floor.
struct HeardRadio {
  const RadioMap* map = nullptr;
  std::vector<MapSweep> scans;
};

std::vector<HeardRadio> HeardRadios(const Site& site, const Evidence& evidence,
                                    const FingerprintSettings& settings, const FloorPath& floors) {
  std::vector<HeardRadio> radios;
  for (const RadioMap* map : MapsOnPath(site, settings, floors)) {
    HeardRadio heard{map, CollectMapSweeps(site, *map, evidence, settings, floors)};
    if (!heard.scans.empty()) radios.push_back(std::move(heard));
  }
  return radios;
}

// One state for all radios and floors: where their maps differ, the worse is the honest one. Shares
// of it by each map's own calibration were tried: what pieces of 20 s say of one floor is too bold
// for a walk of minutes (half of the museum's waypoints were left in the 95 % ellipses).
double MapErrorSigma(const std::vector<HeardRadio>& radios, const MapErrorSettings& settings) {
  if (settings.sigma_m > 0) return settings.sigma_m;
  double sigma_m = 0;
  for (const HeardRadio& radio : radios) {
    sigma_m = std::max(sigma_m, radio.map->map_error_sigma_m);
  }
  return sigma_m;
}

void AddRadios(const Site& site, const Evidence& evidence, const FactorSettings& settings,
               WalkGraph* walk) {
  const std::vector<HeardRadio> radios =
      HeardRadios(site, evidence, settings.fingerprint, walk->floors);
  if (radios.empty()) return;
  const TimeNs begin_ns = walk->node_ns.front();
  const double error_sigma_m = MapErrorSigma(radios, settings.map_error);
  std::vector<const RadioMap*> widened_by;
  if (settings.map_error.widens && !settings.map_error.grows) {
    for (const HeardRadio& radio : radios) widened_by.push_back(radio.map);
  }
  const KnotBlocks map_error =
      AddMapErrorState(BlockKind::kMapError, settings.map_error, error_sigma_m, widened_by, walk);
  std::map<Radio, int> offsets;  // one on all floors
  for (const HeardRadio& radio : radios) {
    const Radio kind = radio.map->radio;
    if (!offsets.contains(kind)) {
      offsets[kind] =
          AddRssiOffsetState(PriorOfRssiOffset(site, evidence, kind, settings.rssi_offset), kind,
                             begin_ns, &walk->graph);
    }
    const int offset = offsets[kind];
    const double growth_per_sigma = GrowthPerSigma(*radio.map, settings.map_error, error_sigma_m);
    for (const MapSweep& part : CollectMapSweeps(site, *radio.map, evidence, settings.fingerprint,
                                                 walk->floors, kSamePlaceS)) {
      AddPositionAtTime(
          MakeFingerprint(*radio.map, part, settings.fingerprint.loss, growth_per_sigma),
          part.mean_heard_ns,
          {map_error.At(part.mean_heard_ns), offset, HeadingNear(*walk, part.mean_heard_ns)},
          part.printed_ns, walk);
    }
    for (const MapSweep& scan : radio.scans) {
      AddPositionAtTime(MakeHearing(*radio.map, scan, growth_per_sigma), scan.mean_heard_ns,
                        {map_error.At(scan.mean_heard_ns)}, scan.printed_ns, walk);
    }
  }
}

// Without anything else that is absolute they would be taken for what they are not, a position.
void AddMagneticLooks(const Site& site, const Evidence& evidence, const FactorSettings& settings,
                      WalkGraph* walk) {
  if (!walk->first_absolute_position_ns) return;
  const std::vector<MagneticLook> looks =
      CollectMagneticLooks(site, evidence, settings.magnetic, walk->floors);
  if (looks.empty()) return;
  double error_sigma_m = 0;
  for (const MagneticLook& look : looks) {
    error_sigma_m = std::max(error_sigma_m, look.map->map_error_sigma_m);
  }
  const KnotBlocks error =
      AddMapErrorState(BlockKind::kMagneticError, settings.map_error, error_sigma_m, {}, walk);
  for (const MagneticLook& look : looks) {
    auto cost = std::make_unique<MagneticFactor>(look);
    GraphFactor factor;
    factor.type = MagneticFactor::kName;
    factor.log_normaliser = cost->LogNormaliser() - cost->CostConstant();
    factor.whitened_rows = MagneticFactor::kComponents;
    factor.dimension = MagneticFactor::kComponents;
    factor.weight = cost->weight();
    factor.cost = std::move(cost);
    AddAtTime(std::move(factor), look.time_ns, {error.At(look.time_ns)}, look.time_ns, walk);
  }
}

void AddAnchors(const Evidence& evidence, WalkGraph* walk) {
  for (const PositionAnchor& anchor : evidence.anchors) {
    if (anchor.floor != walk->floors.At(anchor.time_ns)) continue;
    const PositionAnchorFactor factor{anchor.position_m.x(), anchor.position_m.y(), anchor.sigma_m};
    AddPositionAtTime(MakeGraphFactor(factor, {}), anchor.time_ns, {}, anchor.time_ns, walk);
  }
}

}  // namespace

void AddAbsolutePositions(const Site& site, const Evidence& evidence,
                          const FactorSettings& settings, WalkGraph* walk) {
  AddRadios(site, evidence, settings, walk);
  AddAnchors(evidence, walk);
  AddMagneticLooks(site, evidence, settings, walk);
}

}  // namespace walkgraph
