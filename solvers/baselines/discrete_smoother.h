#ifndef WALKGRAPH_SOLVERS_BASELINES_DISCRETE_SMOOTHER_H_
#define WALKGRAPH_SOLVERS_BASELINES_DISCRETE_SMOOTHER_H_

#include <vector>

#include "factors/dead_reckoning.h"
#include "factors/floor_path.h"
#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

struct DiscreteSettings {
  double spacing_m = 1.5;
  double reach_m = 20.0;  // cells lie no farther from a survey path
  double epoch_s = 4.0;   // states are this far apart; readings between move with the walk
  double heading_bin_rad = 0.1;
  double heading_range_sigmas = 2.5;  // bins on either side, in sigmas of the heading offset
  double beam_nats = 25.0;            // states this much worse than the epoch's best are dropped
  int paths = 4;                      // distinct paths returned at most
  double distinct_m = 6.0;            // mean distance that makes two paths distinct
};

template <typename Visitor>
void Visit(Visitor& v, DiscreteSettings& s) {
  v.Field("spacing_m", s.spacing_m, "side of a cell, m");
  v.Field("reach_m", s.reach_m, "cells lie no farther from a survey path, m");
  v.Field("epoch_s", s.epoch_s, "time between states, s");
  v.Field("heading_bin_rad", s.heading_bin_rad, "width of a bin of the heading offset, rad");
  v.Field("heading_range_sigmas", s.heading_range_sigmas,
          "bins on either side, in sigmas of the heading offset");
  v.Field("beam_nats", s.beam_nats, "states this much worse than the best are dropped, nats");
  v.Field("paths", s.paths, "distinct paths returned at most");
  v.Field("distinct_m", s.distinct_m, "mean distance that makes two paths distinct, m");
}

// A path through the lattice's cells.
struct DiscretePath {
  double negative_log_posterior = 0;   // nats, up to a constant that all paths of a floor share
  Stream<Eigen::Vector2d> position_m;  // at the epochs
  // At the epochs, unwrapped, to add to the dead-reckoned heading.
  Stream<double> heading_offset_rad;

  // Between epochs the path follows `walk`, turned by the epoch's heading offset, with what it
  // misses the next epoch's cell by added linearly in time.
  Eigen::Vector2d PositionAt(const DeadReckonedPath& walk, TimeNs time_ns) const;
};

// The most probable paths, on which the floors are known (Viterbi over cell and heading-offset
// bin), best first: evidence of a time is looked up on the floor of that time, and walk, radio map
// and noise are the graph's, with the step noise and half a cell's quantisation on every
// transition. Where nothing gives an absolute heading the bins cover the circle; where there is no
// heading at all a transition is a disc as wide as the distance walked. Empty where the floors have
// no cells or the evidence holds neither readings that they know nor anchors on them.
std::vector<DiscretePath> SmoothOnLattice(const Site& site, const Evidence& evidence,
                                          const DeadReckonedPath& walk,
                                          const FactorSettings& factors,
                                          const DiscreteSettings& settings,
                                          const FloorPath& floors);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_DISCRETE_SMOOTHER_H_
