#ifndef WALKGRAPH_SOLVERS_BASELINES_LIKELIHOOD_GRID_H_
#define WALKGRAPH_SOLVERS_BASELINES_LIKELIHOOD_GRID_H_

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "factors/map_sweeps.h"
#include "factors/rssi_offset.h"
#include "factors/settings.h"
#include "frontends/radio_map/radio_map.h"

namespace walkgraph {

// -log p of sweeps over many positions at once. For a sweep of readings z_i and a position x
//   -log p = weight * (h silence_share * S(x)
//            + sum_i [rho(sqrt(p_i) (z_i - mean_i(x)) / sigma_i(x)) / 2 + log(sigma_i(x) /
//            sigma_min)
//                     - h logit p_hear_i(x)])
// where p_i is a reading's precision and S sums -log(1 - p_hear) over all transmitters, so that
// -logit turns the silence of a heard one into its -log p_hear, and h is the map's hear_weight: the
// full likelihood that the factors of the graph have, up to a constant. The graph's RSSI offset is
// a state; here an offset common to the sweep's readings, with the same prior, is integrated out
// (under a loss rho that is no square, in the quadratic of its weights).
class LikelihoodGrid {
 public:
  // Keeps a reference to `map`, which must outlive it; `positions_m` may lie anywhere.
  LikelihoodGrid(const RadioMap& map, std::span<const Eigen::Vector2d> positions_m,
                 const RssiOffsetPrior& offset, const LossSettings& loss = {});

  // For each sweep -log p (nats) at each position, in the order of the constructor. Each field is
  // evaluated once, however many sweeps heard it, and only where it differs from its background.
  std::vector<std::vector<float>> Evaluate(std::span<const MapSweep> sweeps) const;

 private:
  struct Segment {
    std::size_t begin = 0, end = 0;  // into the positions sorted by cell
    Eigen::Index size() const { return static_cast<Eigen::Index>(end - begin); }
  };
  struct Terms;
  struct FieldSamples;
  struct Hearing;

  std::vector<Segment> TouchedSegments(const RadioMap::TransmitterField& field) const;
  FieldSamples Sample(const RadioMap::TransmitterField& field,
                      const std::vector<Segment>& segments) const;
  void AddBearings(const RadioMap::TransmitterField& field, const std::vector<Segment>& segments,
                   FieldSamples* samples) const;
  static void AddDifferences(const Terms& terms, const std::vector<Segment>& segments, Terms* sums,
                             Terms* background);

  const RadioMap& map_;
  RssiOffsetPrior offset_;
  LossSettings loss_;
  // Positions sorted by (row, column) of their first control point, so that a rectangle of the grid
  // is a few contiguous runs.
  std::vector<std::size_t> original_index_;
  Eigen::ArrayXf x_m_, y_m_;
  std::vector<std::array<int, 2>> cell_;        // row, column
  std::vector<std::array<float, 16>> weights_;  // as FieldBasis::weight
  std::vector<float> silence_nats_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_LIKELIHOOD_GRID_H_
