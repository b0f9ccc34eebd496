#include "data/simulator/shadow_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace walkgraph {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr int kWaves = 96;

}  // namespace

ShadowField ShadowField::Planar(double correlation_length_m, Random* random) {
  ShadowField field;
  for (int i = 0; i < kWaves; ++i) {
    // exp(-d / L) in the plane has the spectrum (1 + (k L)^2)^(-3/2), whose distribution of k
    // inverts in closed form.
    const double u = std::max(random->Uniform(), 1e-6);
    const double k = std::sqrt(1.0 / (u * u) - 1.0) / correlation_length_m;
    const double direction = random->Uniform(0.0, kTurn);
    const double phase = random->Uniform(0.0, kTurn);
    field.waves_.push_back({{k * std::cos(direction), k * std::sin(direction), 0.0}, phase});
  }
  return field;
}

ShadowField ShadowField::Spatial(double correlation_length_m, Random* random) {
  // The spectrum of exp(-d / L) in any dimension is a multivariate Cauchy distribution: a vector of
  // normals over the size of another one (Rasmussen and Williams, section 4.2.1, Matern with 1/2).
  ShadowField field;
  for (int i = 0; i < kWaves; ++i) {
    const double scale = std::max(std::abs(random->Normal()), 1e-6) * correlation_length_m;
    Eigen::Vector3d wave_vector;
    for (double& component : wave_vector) component = random->Normal() / scale;
    field.waves_.push_back({wave_vector, random->Uniform(0.0, kTurn)});
  }
  return field;
}

double ShadowField::At(const Eigen::Vector3d& position_m) const {
  double sum = 0;
  for (const Wave& wave : waves_) {
    sum += std::cos(wave.wave_vector.dot(position_m) + wave.phase_rad);
  }
  return sum * std::sqrt(2.0 / kWaves);
}

}  // namespace walkgraph
