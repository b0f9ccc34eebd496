#ifndef WALKGRAPH_DATA_TRUTH_H_
#define WALKGRAPH_DATA_TRUTH_H_

#include <Eigen/Core>
#include <vector>

#include "data/time.h"

namespace walkgraph {

// A surveyed point that the person passed at a known time.
struct Waypoint {
  TimeNs time_ns = 0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // see Truth::frame
  int floor = 0;
};

enum class TruthFrame {
  kBuilding,  // position = (x, y) in metres
  kWgs84,     // position = (latitude, longitude) in degrees; ToBuildingFrame() converts
};

// Ground truth of one walk, in order of time. Deliberately not part of Recording: no estimator can
// receive it.
struct Truth {
  TruthFrame frame = TruthFrame::kBuilding;
  std::vector<Waypoint> waypoints;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_TRUTH_H_
