#ifndef WALKGRAPH_SOLVERS_BASELINES_DSFF_TRANSITION_H_
#define WALKGRAPH_SOLVERS_BASELINES_DSFF_TRANSITION_H_

#include <optional>
#include <vector>

#include "frontends/radio_map/site.h"
#include "solvers/baselines/dsff/cells.h"
#include "solvers/baselines/dsff/error_block.h"
#include "solvers/baselines/dsff/motion.h"
#include "solvers/baselines/walls.h"

namespace walkgraph {

// A relative sensor: its normal density alone, or with what its errors so far have taught.
class RelativeSensor {
 public:
  RelativeSensor(double sigma, bool learns, const ErrorBlockSettings& settings)
      : sigma_(sigma), block_(learns ? std::optional(ErrorBlock(sigma, settings)) : std::nullopt) {}

  // log density of the true value's deviation from the reading.
  double LogDensity(double deviation) const;
  void Learn(double error) {
    if (block_) block_->Add(error);
  }
  // Nullptr where nothing is learnt.
  const ErrorBlock* block() const { return block_ ? &*block_ : nullptr; }

 private:
  double sigma_;
  std::optional<ErrorBlock> block_;
};

// The three of them: length of a step, m; heading, rad; height, m.
struct RelativeSensors {
  RelativeSensor distance, heading, height;
};

// log of ring x fan for every offset between cells, of one epoch. Offsets farther than
// `max_distance_m` or more than 30 nats under the best are left out. A way without steps has the
// error of one step; staying has no direction and gets the mean of a fan over the circle.
struct TransitionKernel {
  struct Entry {
    ReferencePoints::Cell offset;
    double log_probability = 0;
  };
  std::vector<Entry> entries;
};
TransitionKernel MakeKernel(const DsffMotion& motion, const RelativeSensors& sensors,
                            double spacing_m, double max_distance_m);

// What the sensors got wrong on a way from cell to cell, as the trace has it: each learns its error
// where it measured something.
void LearnFromTrace(const DsffMotion& motion, const Eigen::Vector2d& way_m,
                    std::optional<double> height_error_m, RelativeSensors* sensors);

// What the building forbids: no way runs through a wall, and one that begins at a junction shares
// its probability with the other branches.
class MapMatching {
 public:
  struct Settings {
    double merge_m = 3;          // of survey points into a way network, where there is none
    double straight_rad = 0.35;  // a node that turns less is no junction
    double junction_radius_m = 1;
  };
  MapMatching(const Site& site, const DsffCells& cells, const Settings& settings);

  bool Blocks(int from, int to) const;
  double LogBranchShare(int from) const {
    return log_branch_share_[static_cast<std::size_t>(from)];
  }

 private:
  const DsffCells& cells_;
  std::vector<Walls> walls_;  // by floor
  std::vector<double> log_branch_share_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_DSFF_TRANSITION_H_
