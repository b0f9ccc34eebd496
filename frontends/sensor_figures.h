#ifndef WALKGRAPH_FRONTENDS_SENSOR_FIGURES_H_
#define WALKGRAPH_FRONTENDS_SENSOR_FIGURES_H_

#include <cstdint>
#include <vector>

#include "data/truth.h"
#include "frontends/evidence/evidence.h"

namespace walkgraph {

// What the sensors of a walk are worth against its truth, in the figures of the HIPE paper and a
// few more. For reports and calibration only: estimators never see the truth.

// Direction of a straight leg minus absolute heading, over the samples of such legs.
struct HeadingFigures {
  std::int64_t samples = 0;
  double sum_rad = 0;
  double sum_squared_rad2 = 0;

  void Add(double error_rad);
  void Add(const HeadingFigures& other);
  double MeanRad() const;  // signed; 0 without samples
  double RmsRad() const;   // 0 without samples
};

// The way from one waypoint to the next on the same floor.
struct LegFigures {
  TimeNs begin_ns = 0;
  TimeNs end_ns = 0;
  double true_m = 0;       // straight line between the waypoints
  double estimated_m = 0;  // step lengths inside the leg, a step across its end in part
  double steps = 0;
  bool straight = false;  // by the gyroscope: walked distance and direction can be compared
  // Dead-reckoned displacement (steps along the gyroscope's yaw, else the absolute heading) against
  // the true one, after the one rotation and scale that suits the walk's legs best, over true_m.
  // NaN where the walk has fewer than two legs or no heading.
  double displacement_error = 0;

  double DistanceRate() const { return (estimated_m - true_m) / true_m; }
};

struct SensorFigures {
  HeadingFigures heading_walking;
  HeadingFigures heading_standing;
  std::vector<LegFigures> legs;  // at least kMinLegM long, by time
};

inline constexpr double kMinLegM = 3.0;  // shorter legs say more about waypoints than about sensors
inline constexpr double kStraightRad = 0.35;  // 20 degrees

// A leg is straight where the gyroscope's yaw, averaged over a second, stays within kStraightRad of
// its mean over the leg. `truth` is in the building frame (throws std::invalid_argument otherwise);
// `heading_to_building_rad` turns an east-north heading into it.
SensorFigures ComputeSensorFigures(const Evidence& evidence, const Truth& truth,
                                   double heading_to_building_rad);

// The figures of many walks as one row. Angles in radians.
struct SensorSummary {
  std::int64_t walks = 0;
  std::int64_t legs = 0;
  std::int64_t straight_legs = 0;
  HeadingFigures heading_walking;
  HeadingFigures heading_standing;
  // Over straight legs; NaN where there is none.
  double distance_rate_mean = 0;
  double distance_rate_median = 0;
  double distance_rate_std = 0;
  // Over all legs of walks with at least two; NaN where there is none.
  double displacement_error_median = 0;
  double displacement_error_p90 = 0;
};
SensorSummary Summarize(const std::vector<SensorFigures>& walks);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_SENSOR_FIGURES_H_
