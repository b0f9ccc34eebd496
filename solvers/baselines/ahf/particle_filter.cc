#include "solvers/baselines/ahf/particle_filter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "data/angle.h"

namespace walkgraph {

Eigen::Vector2d ParticleFilter::Normal2() {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
  const double angle = 2.0 * std::numbers::pi * Uniform();
  return radius * DirectionOf(angle);
}

ParticleFilter::ParticleFilter(int count, const FreeMotion& motion, std::uint64_t seed,
                               const Eigen::Vector2d& fix_m, double fix_sigma_m)
    : motion_(motion), engine_(seed), particles_(static_cast<std::size_t>(count)) {
  for (Particle& particle : particles_) {
    particle.position_m = fix_m + fix_sigma_m * Normal2();
    particle.velocity_mps = motion_.start_speed_sigma_mps * Normal2();
    particle.weight = 1.0 / count;
  }
}

void ParticleFilter::Predict(double seconds) {
  for (Particle& particle : particles_) {
    const Eigen::Vector2d acceleration = motion_.acceleration_sigma_mps2 * Normal2();
    particle.position_m += seconds * particle.velocity_mps + seconds * seconds / 2 * acceleration;
    particle.velocity_mps += seconds * acceleration;
    const double speed = particle.velocity_mps.norm();
    if (speed > motion_.max_speed_mps) particle.velocity_mps *= motion_.max_speed_mps / speed;
  }
}

void ParticleFilter::Update(const Eigen::Vector2d& fix_m, double fix_sigma_m) {
  // Relative to the nearest particle, so that a fix far from all of them leaves some weight.
  double nearest_m2 = std::numeric_limits<double>::infinity();
  for (const Particle& particle : particles_) {
    nearest_m2 = std::min(nearest_m2, (particle.position_m - fix_m).squaredNorm());
  }
  const double variance_m2 = fix_sigma_m * fix_sigma_m;
  double sum = 0;
  for (Particle& particle : particles_) {
    const double m2 = (particle.position_m - fix_m).squaredNorm();
    particle.weight *= std::exp(-(m2 - nearest_m2) / (2 * variance_m2));
    sum += particle.weight;
  }
  for (Particle& particle : particles_) particle.weight /= sum;
  ResampleWhenNeeded();
}

ParticleFilter::Moments ParticleFilter::Estimate() const {
  Moments moments;
  for (const Particle& particle : particles_) {
    moments.mean_m += particle.weight * particle.position_m;
  }
  for (const Particle& particle : particles_) {
    const Eigen::Vector2d d = particle.position_m - moments.mean_m;
    moments.covariance_m2 += particle.weight * d * d.transpose();
  }
  return moments;
}

void ParticleFilter::ResampleWhenNeeded() {
  double squares = 0;
  for (const Particle& particle : particles_) squares += particle.weight * particle.weight;
  const auto count = static_cast<double>(particles_.size());
  if (1 / squares >= count / 2) return;
  std::vector<Particle> drawn;
  drawn.reserve(particles_.size());
  const double start = Uniform();
  std::size_t source = 0;
  double cumulated = particles_.front().weight;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const double target = (static_cast<double>(i) + start) / count;
    while (cumulated < target && source + 1 < particles_.size()) {
      cumulated += particles_[++source].weight;
    }
    drawn.push_back(particles_[source]);
    drawn.back().weight = 1 / count;
  }
  particles_ = std::move(drawn);
}

}  // namespace walkgraph
