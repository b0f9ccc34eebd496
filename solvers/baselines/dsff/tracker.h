#ifndef WALKGRAPH_SOLVERS_BASELINES_DSFF_TRACKER_H_
#define WALKGRAPH_SOLVERS_BASELINES_DSFF_TRACKER_H_

#include <vector>

#include "solvers/baselines/dsff/cells.h"
#include "solvers/baselines/dsff/extended_map.h"
#include "solvers/baselines/dsff/k_best.h"
#include "solvers/baselines/dsff/motion.h"
#include "solvers/baselines/dsff/transition.h"
#include "solvers/estimator.h"

namespace walkgraph {

struct DsffSettings {
  ReferencePointSettings cells{ReferenceArea::kSurveyed, 1.0, 20.0};
  ExtendedMapSettings map;
  ErrorBlockSettings error_block;
  bool map_matching = true;
  double distance_sigma_m = 0;
  double heading_sigma_rad = 0;
  double height_sigma_m = 0.5;
  double max_speed_mps = 2;
  int k = 3;
  double beam_nats = 40;
};

template <typename Visitor>
void Visit(Visitor& v, DsffSettings& s) {
  Visit(v, s.cells);
  Visit(v, s.map);
  Visit(v, s.error_block);
  v.Field("map_matching", s.map_matching,
          "no way through a wall, 1/branches at a junction (an option of the paper)");
  v.Field("distance_sigma_m", s.distance_sigma_m,
          "error of the length of a step, m; 0 takes the calibrated spread and the cells' share");
  v.Field("heading_sigma_rad", s.heading_sigma_rad,
          "error of a heading, rad; 0 takes the calibrated spread and the cells' share");
  v.Field("height_sigma_m", s.height_sigma_m, "error of a height by the barometer, m (our choice)");
  v.Field("max_speed_mps", s.max_speed_mps, "nobody is taken to be faster, m/s (our choice)");
  v.Field("k", s.k, "traces that every cell keeps (our choice)");
  v.Field("beam_nats", s.beam_nats, "cells this much less likely than the best are given up");
}

// What came of a walk.
struct DsffTrack {
  std::vector<KBestViterbi::Trace> traces;  // best first
  int restarts = 0;                         // epochs that no way led to
  std::vector<SlowStateEstimate> learnt;    // mean and spread of the error blocks by epoch
};

// The hidden Markov model of DSFF with error correction: epoch by epoch the sensors' densities, as
// corrected by the errors learnt so far, make the transition; the best trace until then says what
// the sensors got wrong, which they learn and never revise. The heights of floors count from
// `first_height_m`, the height at the first epoch. `map_matching` may be null.
DsffTrack TrackByErrorBlocks(const DsffCells& cells, const AbsoluteEvidence& evidence,
                             const std::vector<DsffMotion>& motion, RelativeSensors sensors,
                             double first_height_m, const MapMatching* map_matching,
                             const DsffSettings& settings);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_DSFF_TRACKER_H_
