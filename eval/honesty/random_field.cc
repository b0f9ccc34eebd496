#include "eval/honesty/random_field.h"

#include <cmath>
#include <numbers>

#include "data/angle.h"

namespace walkgraph {

RandomField RandomField::SquaredExponential(double length_m, Random random) {
  RandomField field;
  for (Wave& wave : field.waves_) {
    wave.vector = {random.Normal() / length_m, random.Normal() / length_m};
    wave.phase_rad = random.Uniform(0, 2 * std::numbers::pi);
  }
  return field;
}

RandomField RandomField::Exponential(double length_m, Random random) {
  RandomField field;
  for (Wave& wave : field.waves_) {
    // In the plane exp(-d / l) has the spectrum (1 + l^2 k^2)^(-3/2) / (2 pi): inside the radius k
    // lies the share 1 - (1 + l^2 k^2)^(-1/2).
    const double outside = 1.0 - random.Uniform();
    const double radius = std::sqrt(1.0 / (outside * outside) - 1.0) / length_m;
    const double direction_rad = random.Uniform(0, 2 * std::numbers::pi);
    wave.vector = radius * DirectionOf(direction_rad);
    wave.phase_rad = random.Uniform(0, 2 * std::numbers::pi);
  }
  return field;
}

double RandomField::At(const Eigen::Vector2d& position_m) const {
  double sum = 0;
  for (const Wave& wave : waves_) sum += std::cos(wave.vector.dot(position_m) + wave.phase_rad);
  return sum * std::sqrt(2.0 / static_cast<double>(waves_.size()));
}

}  // namespace walkgraph
