#include "frontends/radio_map/shift_posterior.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

namespace walkgraph {
namespace {

// Chance that a piece lies where nothing is known: keeps one lost walk from deciding the score.
constexpr double kLostProbability = 0.02;

// Probabilities proportional to area exp(-nats).
Eigen::ArrayXd Normalised(const Eigen::ArrayXd& nats, const Eigen::ArrayXd& area_m2) {
  const Eigen::ArrayXd p = area_m2 * (nats.minCoeff() - nats).exp();
  return p / p.sum();
}

}  // namespace

ShiftGrid::ShiftGrid(double spacing_m, int half_count, int refined_half_count, int parts)
    : lattices_{{spacing_m, half_count, refined_half_count}} {
  if (refined_half_count >= 0) {
    lattices_.push_back({spacing_m / parts, parts * refined_half_count + parts / 2, -1});
  }
  std::vector<double> areas_m2;
  for (std::size_t l = 0; l < lattices_.size(); ++l) {
    const Lattice& lattice = lattices_[l];
    Eigen::Index index = 0;
    for (int row = -lattice.half_count; row <= lattice.half_count; ++row) {
      for (int column = -lattice.half_count; column <= lattice.half_count; ++column, ++index) {
        if (std::max(std::abs(row), std::abs(column)) <= lattice.hole_half_count) continue;
        places_.push_back({l, index});
        shifts_m_.push_back(lattice.spacing_m * Eigen::Vector2d(column, row));
        areas_m2.push_back(lattice.spacing_m * lattice.spacing_m);
      }
    }
  }
  area_m2_ = Eigen::Map<const Eigen::ArrayXd>(areas_m2.data(), std::ssize(areas_m2));
}

Eigen::ArrayXd ShiftGrid::Join(const std::vector<Eigen::ArrayXd>& by_lattice) const {
  Eigen::ArrayXd joined(static_cast<Eigen::Index>(places_.size()));
  for (Eigen::Index i = 0; i < joined.size(); ++i) {
    const Place& place = places_[static_cast<std::size_t>(i)];
    joined[i] = by_lattice[place.lattice][place.index];
  }
  return joined;
}

SharedErrorKernel::SharedErrorKernel(const ShiftGrid& grid, double sigma_m)
    : density_(static_cast<Eigen::Index>(grid.size())),
      lost_density_(kLostProbability / grid.area_m2().sum()) {
  for (std::size_t i = 0; i < grid.size(); ++i) {
    density_[static_cast<Eigen::Index>(i)] =
        std::exp(-0.5 * grid.At(i).squaredNorm() / (sigma_m * sigma_m));
  }
  density_ /= (density_ * grid.area_m2()).sum();
}

double SharedErrorKernel::LogScoreAtTruth(const Eigen::ArrayXd& posterior) const {
  const double density = (posterior * density_).sum();
  return std::log((1.0 - kLostProbability) * density + lost_density_);
}

const SharedErrorKernel& SharedErrorKernels::At(double sigma_m) {
  auto found = by_sigma_m_.find(sigma_m);
  if (found == by_sigma_m_.end()) {
    found = by_sigma_m_.emplace(sigma_m, SharedErrorKernel(grid_, sigma_m)).first;
  }
  return found->second;
}

PiecePosterior::PiecePosterior(const ShiftGrid& grid,
                               const std::vector<Eigen::ArrayXd>& part_nats) {
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(part_nats.front().size());
  for (const Eigen::ArrayXd& nats : part_nats) {
    sum += nats;
    parts_.push_back(Normalised(nats, grid.area_m2()));
  }
  whole_ = Normalised(sum, grid.area_m2());
}

double PiecePosterior::Score(const SharedErrorKernel& kernel) const {
  double alone = 0;
  for (const Eigen::ArrayXd& part : parts_) alone += kernel.LogScoreAtTruth(part);
  return kernel.LogScoreAtTruth(whole_) + alone / static_cast<double>(parts_.size());
}

}  // namespace walkgraph
