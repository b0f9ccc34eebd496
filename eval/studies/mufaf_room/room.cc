#include "room.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "data/angle.h"

namespace walkgraph::mufaf_room {
namespace {

constexpr double kStepM = 0.5, kTurnRad = 0.4;

double Normal(Random* random, double sigma) {
  return std::normal_distribution<double>(0, sigma)(*random);
}

}  // namespace

Shadowing::Shadowing(double sigma_db, Random* random) {
  constexpr double kLengthM = 1.5;
  for (Wave& wave : waves_) {
    wave.vector = {Normal(random, 1 / kLengthM), Normal(random, 1 / kLengthM)};
    wave.phase = std::uniform_real_distribution<double>(0, 2 * std::numbers::pi)(*random);
    wave.amplitude = sigma_db * std::sqrt(2.0 / kWaves);
  }
}

double Shadowing::At(const Eigen::Vector2d& p) const {
  double sum = 0;
  for (const Wave& wave : waves_) sum += wave.amplitude * std::cos(wave.vector.dot(p) + wave.phase);
  return sum;
}

Room::Room(std::uint64_t seed) : random_(seed) {
  for (const RoomRadio& radio : kRadios) {
    shadowing_.emplace_back();
    for (Eigen::Index a = 0; a < kAnchors; ++a) {
      shadowing_.back().emplace_back(radio.shadowing_db, &random_);
    }
  }
}

Eigen::VectorXd Room::Mean(std::size_t radio, const Eigen::Vector2d& p) const {
  Eigen::VectorXd mean(kAnchors);
  for (Eigen::Index a = 0; a < kAnchors; ++a) {
    const Eigen::Vector2d anchor((a % 2) * kColumns, (a / 2) * kRows);
    const double distance_m = std::max(0.3, (p - anchor).norm());
    mean[a] = -40 - 10 * kRadios[radio].exponent * std::log10(distance_m) +
              shadowing_[radio][static_cast<std::size_t>(a)].At(p);
  }
  return mean;
}

Eigen::VectorXd Room::Hear(std::size_t radio, const Eigen::Vector2d& p, int samples) {
  Eigen::VectorXd heard = Mean(radio, p);
  for (double& value : heard)
    value += Normal(&random_, kRadios[radio].noise_db / std::sqrt(samples));
  return heard;
}

CellMap Room::Survey(std::size_t radio, int samples) {
  CellMap map(kAnchors);
  const double variance = kRadios[radio].noise_db * kRadios[radio].noise_db;
  for (int cell = 0; cell < kColumns * kRows; ++cell) {
    const Eigen::Vector2d center(cell % kColumns + 0.5, cell / kColumns + 0.5);
    map.AddCell(center, Hear(radio, center, samples), Eigen::VectorXd::Constant(kAnchors, variance),
                samples);
  }
  return map;
}

std::vector<Eigen::Vector2d> Room::Route() {
  std::uniform_real_distribution<double> x(0, kColumns), y(0, kRows),
      angle(-std::numbers::pi, std::numbers::pi);
  const double x0 = x(random_), y0 = y(random_);
  std::vector<Eigen::Vector2d> route = {{x0, y0}};
  double heading = angle(random_);
  while (route.size() < kSteps) {
    heading += Normal(&random_, kTurnRad);
    const Eigen::Vector2d next = route.back() + kStepM * DirectionOf(heading);
    if (next.x() < 0 || next.x() > kColumns || next.y() < 0 || next.y() > kRows) {
      heading = angle(random_);
      continue;
    }
    route.push_back(next);
  }
  return route;
}

}  // namespace walkgraph::mufaf_room
