#ifndef WALKGRAPH_FACTORS_DEAD_RECKONING_H_
#define WALKGRAPH_FACTORS_DEAD_RECKONING_H_

#include <Eigen/Core>

#include "data/recording.h"
#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

enum class HeadingSource { kAbsolute, kGyroscope, kNone };

// The walk as the steps and headings alone give it, from an origin at (0, 0): the slow states are
// at their prior means. Baselines move along it, and initial trajectories of the graph start from
// it.
struct DeadReckonedPath {
  Stream<Eigen::Vector2d>
      position_m;  // building axes; at the beginning, every step's ends, the end
  HeadingSource source = HeadingSource::kNone;
  Stream<double> heading_rad;  // of walking, unwrapped; in the building frame only if kAbsolute

  // Linear in time, clamped at the ends.
  Eigen::Vector2d PositionAt(TimeNs time_ns) const;
  // Zero where there is no heading at all.
  double HeadingAt(TimeNs time_ns) const;
};

// Absolute headings where the evidence has them (and they are enabled), else integrated gyroscope
// yaw from an unknown start of zero, else straight ahead.
DeadReckonedPath DeadReckon(const Site& site, const Evidence& evidence,
                            const FactorSettings& settings);

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_DEAD_RECKONING_H_
