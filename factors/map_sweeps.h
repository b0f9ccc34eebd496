#ifndef WALKGRAPH_FACTORS_MAP_SWEEPS_H_
#define WALKGRAPH_FACTORS_MAP_SWEEPS_H_

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "data/time.h"
#include "factors/floor_path.h"
#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/radio_map.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// The readings of one printed scan that a map knows, or a part of them that was heard within a
// short time (see CollectMapSweeps).
struct MapSweep {
  struct Reading {
    int field = 0;  // index into RadioMap::fields
    float rssi_dbm = 0;
    TimeNs heard_ns = 0;
    float precision = 1;  // what the map's variance is divided by, in (0, 1] (see RefreshRate)
  };
  Radio radio = Radio::kWifi;
  TimeNs printed_ns = 0;
  TimeNs mean_heard_ns = 0;
  // min(1, N_eff / N) with N the known readings of the whole scan: they are not independent.
  double weight = 1;
  double silence_share = 1;       // of the scan's cost of silence that falls to this part
  std::vector<Reading> readings;  // by heard_ns, never empty
  // Direction of walking, a unit vector, for methods whose state has none; zero: not known.
  Eigen::Vector2d facing = Eigen::Vector2d::Zero();
};

// Groups the evidence's readings of the map's radio by scan, in order of time. Readings unknown to
// the map or weaker than settings.min_rssi_dbm are left out. A scan heard over more than
// `max_span_s` is cut into parts of equal duration no longer than that; its silence is shared out
// by their readings. N_eff is settings.n_eff or, where that is 0, the map's; a weight of 1 where
// both are 0. With settings.refresh_rate a reading heard while walking has the precision of
// RefreshRate: the weaker it is, the likelier it is an old one, of a place passed before.
std::vector<MapSweep> CollectMapSweeps(const Site& site, const RadioMap& map,
                                       const Evidence& evidence,
                                       const FingerprintSettings& settings,
                                       double max_span_s = std::numeric_limits<double>::infinity());

// The same without those heard while the walk was on another floor than the map's.
std::vector<MapSweep> CollectMapSweeps(const Site& site, const RadioMap& map,
                                       const Evidence& evidence,
                                       const FingerprintSettings& settings, const FloorPath& floors,
                                       double max_span_s = std::numeric_limits<double>::infinity());

// Maps of the radios that are switched on, on the floors of a walk: by floor, then radio.
std::vector<const RadioMap*> MapsOnPath(const Site& site, const FingerprintSettings& settings,
                                        const FloorPath& floors);

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_MAP_SWEEPS_H_
