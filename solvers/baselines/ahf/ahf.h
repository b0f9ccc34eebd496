#ifndef WALKGRAPH_SOLVERS_BASELINES_AHF_AHF_H_
#define WALKGRAPH_SOLVERS_BASELINES_AHF_AHF_H_

#include <memory>
#include <string_view>
#include <vector>

#include "factors/settings.h"
#include "solvers/baselines/ahf/filters.h"
#include "solvers/baselines/description.h"
#include "solvers/baselines/wknn.h"
#include "solvers/estimator.h"

namespace walkgraph {

// One of the filters that the paper compares.
struct AhfMethod {
  MethodDescription description;
  AhfPrediction prediction = AhfPrediction::kStraight;
  AhfWeights weights = AhfWeights::kKalman;
  int particles = 0;  // 0: one of the four corners of the ablation
};

inline constexpr std::string_view kAhfSource =
    "Park, Jung, Moon and Han, An Adaptive Hybrid Filter for WiFi-Based Positioning Systems, 2013";
inline constexpr std::string_view kAhfOwnChoices =
    "fixes: WKNN. Ways: the building's, else of the survey walks. Speed: of the last two results, "
    "1 m/s before, 2 m/s at most; the result may leave the ways and is projected on them for the "
    "next prediction. Error of a fix: spread of its 5 nearest fingerprints. The weights are the "
    "products that the paper's printed sums must be. Linear in time between fixes; no covariance";
inline constexpr std::string_view kAhfKalmanChoices =
    "error of a fix and acceleration, which the paper does not print: 5 m and 0.5 m/s^2 per axis; "
    "with ways the speed is kept between 0 and 2 m/s";
inline constexpr std::string_view kAhfParticleChoices =
    "the paper does not say how its particles move: as the basic Kalman filter's state, at 2 m/s "
    "at most, without walls; weights normal about the fix, resampled under half the effective "
    "number. Dynamic weights scale the fix's sigma by its estimated error over the mean so far";

// Every one of them, in the order in which tables list them.
inline constexpr AhfMethod kAhfMethods[] = {
    {{"ahf", "adaptive hybrid filter: WKNN fixes and way network, weighed by estimated errors",
      kAhfSource, kAhfOwnChoices},
     AhfPrediction::kWays,
     AhfWeights::kDynamic},
    {{"ahf_kalman", "AHF's rival: WKNN fixes in a Kalman filter of position and velocity",
      kAhfSource, kAhfKalmanChoices},
     AhfPrediction::kStraight,
     AhfWeights::kKalman},
    {{"ahf_kalman_dynamic", "AHF without ways: straight prediction, dynamic weights", kAhfSource,
      kAhfOwnChoices},
     AhfPrediction::kStraight,
     AhfWeights::kDynamic},
    {{"ahf_ways_kalman", "AHF without dynamic weights: way network, Kalman gain", kAhfSource,
      kAhfKalmanChoices},
     AhfPrediction::kWays,
     AhfWeights::kKalman},
    {{"ahf_particle_1000", "AHF's rival: WKNN fixes in a particle filter, 1,000 particles",
      kAhfSource, kAhfParticleChoices},
     AhfPrediction::kStraight,
     AhfWeights::kKalman,
     1'000},
    {{"ahf_particle_5000", "the same with 5,000 particles", kAhfSource, kAhfParticleChoices},
     AhfPrediction::kStraight,
     AhfWeights::kKalman,
     5'000},
    {{"ahf_particle_10000", "the same with 10,000 particles", kAhfSource, kAhfParticleChoices},
     AhfPrediction::kStraight,
     AhfWeights::kKalman,
     10'000},
    {{"ahf_particle_dynamic", "5,000 particles with dynamic weights", kAhfSource,
      kAhfParticleChoices},
     AhfPrediction::kStraight,
     AhfWeights::kDynamic,
     5'000},
};

// The walk's WKNN fixes with their errors estimated by the best candidate set, in order of time.
std::vector<RatedFix> RateFixes(const Site& site, const Evidence& evidence, int floor,
                                const AhfSettings& settings, const WknnSettings& wknn);

// A filter over the WKNN fixes of the walk. The slow states hold "bcs_error_m" at every fix.
// Without any way on the floor a method that needs them is unsupported.
class AhfEstimator : public Estimator {
 public:
  AhfEstimator(const AhfMethod& method, const AhfSettings& settings, const WknnSettings& wknn,
               const FactorSettings& factors)
      : method_(method), settings_(settings), wknn_(wknn), factors_(factors) {}
  std::string_view name() const override { return method_.description.name; }
  EstimateResult Estimate(const Site& site, const Evidence& evidence) const override;

 private:
  std::unique_ptr<PositionFilter> MakeFilter(const WayGraph& ways) const;

  AhfMethod method_;
  AhfSettings settings_;
  WknnSettings wknn_;
  FactorSettings factors_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_AHF_AHF_H_
