#ifndef WALKGRAPH_SOLVERS_BASELINES_HIPE_MOTION_H_
#define WALKGRAPH_SOLVERS_BASELINES_HIPE_MOTION_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "data/building.h"
#include "data/time.h"
#include "factors/dead_reckoning.h"
#include "frontends/evidence/evidence.h"
#include "solvers/baselines/discrete.h"
#include "solvers/baselines/reference_points.h"
#include "solvers/baselines/walkable_ways.h"

namespace walkgraph {

// Which motion dynamics information (MDI) a phone measures: table 1 of the HIPE paper.
enum class HipeCase : std::uint8_t {
  kDistanceHeading,  // eq. 9: ring and sector
  kDistance,         // eq. 7: ring
  kHeadingSpeed,     // eq. 8: sector within the range of the maximum speed
  kSpeed,            // eq. 10: disc of that range
};
inline constexpr std::array<std::string_view, 4> kHipeCaseNames = {"distance_heading", "distance",
                                                                   "heading_speed", "speed"};

enum class HipeDistance : std::uint8_t {
  kEuclidean,  // eqs. 7-10
  kWalkable,   // the text: shortest way from point to point that crosses no obstacle
};
inline constexpr std::array<std::string_view, 2> kHipeDistanceNames = {"euclidean", "walkable"};

struct HipeMotionSettings {
  HipeCase motion_case = HipeCase::kDistanceHeading;
  HipeDistance distance = HipeDistance::kEuclidean;
  double step_length_m = 0.70;
  double tolerance_share = 0.10;
  double heading_tolerance_rad = 0.9599310885968813;  // 55 degrees
  double max_speed_mps = 1.0;
  double max_distance_m = 40;
};

template <typename Visitor>
void Visit(Visitor& v, HipeMotionSettings& s) {
  v.Field("motion_case", s.motion_case,
          "measured motion: distance_heading, distance, heading_speed or speed");
  v.Field("distance", s.distance, "between reference points: euclidean or walkable");
  v.Field("step_length_m", s.step_length_m,
          "constant length of a step, m; 0 takes the calibrated step lengths");
  v.Field("tolerance_share", s.tolerance_share,
          "tolerated share of a distance; at least half the spacing of the points");
  v.Field("heading_tolerance_rad", s.heading_tolerance_rad, "tolerated heading error, rad");
  v.Field("max_speed_mps", s.max_speed_mps, "assumed where no distance is measured, m/s");
  v.Field("max_distance_m", s.max_distance_m, "longest distance in the table of pairs, m");
}

// What was measured between two epochs.
struct MotionInformation {
  std::optional<double> distance_m;   // walked
  double distance_tolerance_m = 0;    // eps
  std::optional<double> heading_rad;  // in the building frame; NaN-free
  double heading_tolerance_rad = 0;   // gamma
  double range_m = 0;                 // rho, where there is no distance
};

// Is going `distance_m` in `direction_rad` what was measured? Staying (distance 0) has no direction
// and passes that test.
bool IsConsistent(const MotionInformation& motion, double distance_m, double direction_rad);

// Steps are counted by the share of each that lies in the interval; the heading is the direction of
// their sum, without steps (or without distance in the case) the mean of the headings of the time.
// `path` tells the headings; a case that needs them falls back to the one without where they are
// not absolute.
MotionInformation MeasureMotion(const Evidence& evidence, const DeadReckonedPath& path,
                                double step_scale, TimeNs begin_ns, TimeNs end_ns, double spacing_m,
                                const HipeMotionSettings& settings);

// For each reference point those that are consistent with a motion from it.
struct ConsistentPairs {
  std::vector<std::size_t> begin{0};
  std::vector<int> to;
};

// Eqs. 5, 6 and 11: of N states the I consistent ones a_h = K a_l, a_l = 1 / (N + (K - 1) I);
// 1/N each where none is consistent.
TransitionRows HipeTransition(const ConsistentPairs& pairs, double k);

// The table of distances and directions between reference points, to max_distance_m.
class ReferencePairs {
 public:
  // `obstacles` bound the way where the distance is walkable.
  // Keeps a reference to `points`, which must outlive it.
  ReferencePairs(const ReferencePoints& points, std::span<const Polygon> obstacles,
                 HipeDistance distance, double max_distance_m);
  ConsistentPairs Find(const MotionInformation& motion) const;

 private:
  // From a point to the one `cell` away; the same for all points where distances are Euclidean.
  struct Offset {
    ReferencePoints::Cell cell;
    double distance_m = 0;
    double direction_rad = 0;
  };

  const ReferencePoints& points_;
  HipeDistance distance_;
  std::vector<Offset> offsets_;                 // Euclidean
  std::vector<std::vector<WalkableWay>> ways_;  // walkable: from each point, by `to`
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_HIPE_MOTION_H_
