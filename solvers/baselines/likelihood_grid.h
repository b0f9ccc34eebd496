#ifndef WALKGRAPH_SOLVERS_BASELINES_LIKELIHOOD_GRID_H_
#define WALKGRAPH_SOLVERS_BASELINES_LIKELIHOOD_GRID_H_

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "data/time.h"
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
  };
  Radio radio = Radio::kWifi;
  TimeNs mean_heard_ns = 0;
  // min(1, N_eff / N) with N the known readings of the whole scan: they are not independent.
  double weight = 1;
  double silence_share = 1;       // of the scan's cost of silence that falls to this part
  std::vector<Reading> readings;  // by heard_ns, never empty
};

// Groups the evidence's readings of the map's radio by scan, in order of time. Readings unknown to
// the map or weaker than settings.min_rssi_dbm are left out. A scan heard over more than
// `max_span_s` is cut into parts of equal duration no longer than that; its silence is shared out
// by their readings. N_eff is settings.n_eff or, where that is 0, the map's; a weight of 1 where
// both are 0.
std::vector<MapSweep> CollectMapSweeps(const Site& site, const RadioMap& map,
                                       const Evidence& evidence,
                                       const FingerprintSettings& settings,
                                       double max_span_s = std::numeric_limits<double>::infinity());

// -log p of sweeps over many positions at once. For a sweep of readings z_i and a position x
//   -log p = weight * (silence_share * S(x)
//            + sum_i [((z_i - mean_i(x)) / sigma_i(x))^2 / 2 + log(sigma_i(x) / sigma_min)
//                     - logit p_hear_i(x)])
// where S sums -log(1 - p_hear) over all transmitters, so that -logit turns the silence of a heard
// one into its -log p_hear: the full likelihood that the fingerprint factor has, up to a constant.
class LikelihoodGrid {
 public:
  // Keeps a reference to `map`, which must outlive it; `positions_m` may lie anywhere.
  LikelihoodGrid(const RadioMap& map, std::span<const Eigen::Vector2d> positions_m);

  // For each sweep -log p (nats) at each position, in the order of the constructor. Each field is
  // evaluated once, however many sweeps heard it, and only where it differs from its background.
  std::vector<std::vector<float>> Evaluate(std::span<const MapSweep> sweeps) const;

 private:
  struct Segment {
    std::size_t begin = 0, end = 0;  // into the positions sorted by cell
  };
  struct FieldSamples;
  struct Hearing;

  std::vector<Segment> TouchedSegments(const RadioMap::TransmitterField& field) const;
  FieldSamples Sample(const RadioMap::TransmitterField& field,
                      const std::vector<Segment>& segments) const;

  const RadioMap& map_;
  // Positions sorted by (row, column) of their first control point, so that a rectangle of the grid
  // is a few contiguous runs.
  std::vector<std::size_t> original_index_;
  std::vector<std::array<int, 2>> cell_;        // row, column
  std::vector<std::array<float, 16>> weights_;  // as FieldBasis::weight
  std::vector<float> silence_nats_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_LIKELIHOOD_GRID_H_
