#ifndef WALKGRAPH_SOLVERS_BASELINES_AHF_PARTICLE_FILTER_H_
#define WALKGRAPH_SOLVERS_BASELINES_AHF_PARTICLE_FILTER_H_

#include <Eigen/Core>
#include <cstdint>
#include <random>
#include <vector>

namespace walkgraph {

// How a person moves, for the Kalman and the particle filter alike: constant velocity, disturbed by
// white acceleration.
struct FreeMotion {
  double acceleration_sigma_mps2 = 0;  // per axis, held over the time between two fixes
  double start_speed_sigma_mps = 0;    // per axis
  double max_speed_mps = 0;            // of a particle; faster ones are slowed down to it
};

// Particles with position and velocity on a floor without walls; the estimate is their weighted
// mean. Resampled systematically when the effective number falls under half. The same seed gives
// the same particles on every machine.
class ParticleFilter {
 public:
  struct Moments {
    Eigen::Vector2d mean_m = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance_m2 = Eigen::Matrix2d::Zero();
  };

  // `count` particles around the first fix. Precondition: count > 0.
  ParticleFilter(int count, const FreeMotion& motion, std::uint64_t seed,
                 const Eigen::Vector2d& fix_m, double fix_sigma_m);

  void Predict(double seconds);
  // Weighs by a normal density about the fix, sigma per axis.
  void Update(const Eigen::Vector2d& fix_m, double fix_sigma_m);
  Moments Estimate() const;

 private:
  struct Particle {
    Eigen::Vector2d position_m;
    Eigen::Vector2d velocity_mps;
    double weight = 0;
  };

  double Uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
  // Two independent standard normal numbers by Box and Muller: the distributions of <random> are
  // not the same everywhere.
  Eigen::Vector2d Normal2();
  void ResampleWhenNeeded();

  FreeMotion motion_;
  std::mt19937_64 engine_;
  std::vector<Particle> particles_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_AHF_PARTICLE_FILTER_H_
