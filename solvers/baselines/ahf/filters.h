#ifndef WALKGRAPH_SOLVERS_BASELINES_AHF_FILTERS_H_
#define WALKGRAPH_SOLVERS_BASELINES_AHF_FILTERS_H_

#include <Eigen/Core>
#include <cstdint>
#include <memory>

#include "data/time.h"
#include "solvers/baselines/ahf/particle_filter.h"
#include "solvers/baselines/fixes.h"
#include "solvers/baselines/way_graph.h"

namespace walkgraph {

struct AhfSettings {
  int candidates = 5;
  // The median distance between successive scans of a walk is 2.2 m on ilc20 (site1, F2).
  double fingerprint_spacing_m = 2;
  double merge_m = 4;
  double straight_rad = 0.35;
  double start_speed_mps = 1;
  double max_speed_mps = 2;
  double fix_sigma_m = 5;
  double acceleration_sigma_mps2 = 0.5;
  int seed = 1;
};

template <typename Visitor>
void Visit(Visitor& v, AhfSettings& s) {
  v.Field("candidates", s.candidates,
          "best fingerprints whose spread about the first is the error of a fix (our choice)");
  v.Field("fingerprint_spacing_m", s.fingerprint_spacing_m,
          "spacing of the fingerprints; half of it is the least error of a fix, m");
  v.Field("merge_m", s.merge_m,
          "survey points this near the first of a node make it; where the building has no ways, m");
  v.Field("straight_rad", s.straight_rad,
          "a node between two links that turn by less is no junction, rad");
  v.Field("start_speed_mps", s.start_speed_mps, "speed before there are two positions, m/s");
  v.Field("max_speed_mps", s.max_speed_mps, "nobody is taken to be faster, m/s (our choice)");
  v.Field("fix_sigma_m", s.fix_sigma_m,
          "error of a Wi-Fi fix per axis, for the Kalman gain, m (our choice)");
  v.Field("acceleration_sigma_mps2", s.acceleration_sigma_mps2,
          "white acceleration per axis, for the Kalman gain and the particles, m/s^2 (our choice)");
  v.Field("seed", s.seed, "of the particles");
}

// A Wi-Fi fix and what is known of its error.
struct RatedFix {
  PositionFix fix;
  double error_m = 0;  // estimated by the best candidate set
};

// The place after a fix, as a filter tells it. The covariance is NaN where the filter has none.
class PositionFilter {
 public:
  virtual ~PositionFilter() = default;
  // `seconds` since the fix before; ignored at the first.
  virtual PositionFix Advance(const RatedFix& fix, double seconds) = 0;
};

enum class AhfPrediction : std::uint8_t { kStraight, kWays };
enum class AhfWeights : std::uint8_t { kKalman, kDynamic };

// The four corners of the paper's ablation. Way predictions need `ways`, which must outlive the
// filter and not be empty.
std::unique_ptr<PositionFilter> MakeAhfFilter(AhfPrediction prediction, AhfWeights weights,
                                              const WayGraph* ways, const AhfSettings& settings);
// Dynamic weights: the sigma of a fix goes with its estimated error over the mean of those so far.
std::unique_ptr<PositionFilter> MakeParticleFilter(int particles, AhfWeights weights,
                                                   const AhfSettings& settings);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_AHF_FILTERS_H_
