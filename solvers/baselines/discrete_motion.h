#ifndef WALKGRAPH_SOLVERS_BASELINES_DISCRETE_MOTION_H_
#define WALKGRAPH_SOLVERS_BASELINES_DISCRETE_MOTION_H_

#include <Eigen/Core>
#include <vector>

#include "factors/dead_reckoning.h"
#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "solvers/baselines/discrete_smoother.h"

namespace walkgraph {

// How the discrete smoother's walker moves from epoch to epoch.

// The bins of the heading offset and what it costs to be in one or to change.
struct HeadingBins {
  std::vector<double> offset_rad;
  std::vector<float> prior_nats;
  bool circular = false;
  float change_nats = 0;  // to a neighbouring bin within an epoch

  int size() const { return static_cast<int>(offset_rad.size()); }
  // -1 where there is no such bin.
  int Neighbour(int bin, int step) const {
    const int next = bin + step;
    if (circular) return (next + size()) % size();
    return next < 0 || next >= size() ? -1 : next;
  }
};

// Bins over the offset's prior where an absolute heading is there and its offset free, over the
// circle where only the gyroscope tells turns, else the one bin of no offset. `epoch_s` is an
// epoch's length.
HeadingBins MakeBins(HeadingSource source, const FactorSettings& factors,
                     const DiscreteSettings& settings, double epoch_s);

// What happens between two epochs as far as steps and heading say.
struct Transition {
  Eigen::Vector2d displacement_m = Eigen::Vector2d::Zero();  // at heading offset zero
  double variance_m2 = 0;                                    // per axis
};

// Of the steps that end within (begin, end], moved along the dead-reckoned walk; without any
// heading a disc about the start.
Transition MakeTransition(const Evidence& evidence, const DeadReckonedPath& walk, TimeNs begin,
                          TimeNs end, const FactorSettings& factors,
                          const DiscreteSettings& settings);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_DISCRETE_MOTION_H_
