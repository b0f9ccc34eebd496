#include "frontends/radio_map/shift_posterior.h"

#include <cmath>

namespace walkgraph {
namespace {

// Chance that a piece lies where nothing is known: keeps one lost walk from deciding the score.
constexpr double kLostProbability = 0.02;

// Probabilities proportional to exp(-nats).
Eigen::ArrayXd Normalised(const Eigen::ArrayXd& nats) {
  const Eigen::ArrayXd p = (nats.minCoeff() - nats).exp();
  return p / p.sum();
}

}  // namespace

SharedErrorKernel::SharedErrorKernel(const ShiftGrid& grid, double sigma_m)
    : grid_(grid), weight_(static_cast<Eigen::Index>(grid.size())) {
  for (std::size_t i = 0; i < grid.size(); ++i) {
    weight_[static_cast<Eigen::Index>(i)] =
        std::exp(-0.5 * grid.At(i).squaredNorm() / (sigma_m * sigma_m));
  }
  weight_ /= weight_.sum();
}

double SharedErrorKernel::LogScoreAtTruth(const Eigen::ArrayXd& posterior) const {
  const double density = (posterior * weight_).sum() / grid_.cell_m2();
  const double lost = kLostProbability / (static_cast<double>(grid_.size()) * grid_.cell_m2());
  return std::log((1.0 - kLostProbability) * density + lost);
}

const SharedErrorKernel& SharedErrorKernels::At(double sigma_m) {
  auto found = by_sigma_m_.find(sigma_m);
  if (found == by_sigma_m_.end()) {
    found = by_sigma_m_.emplace(sigma_m, SharedErrorKernel(grid_, sigma_m)).first;
  }
  return found->second;
}

PiecePosterior::PiecePosterior(const std::vector<Eigen::ArrayXd>& part_nats) {
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(part_nats.front().size());
  for (const Eigen::ArrayXd& nats : part_nats) {
    sum += nats;
    parts_.push_back(Normalised(nats));
  }
  whole_ = Normalised(sum);
}

double PiecePosterior::Score(const SharedErrorKernel& kernel) const {
  double alone = 0;
  for (const Eigen::ArrayXd& part : parts_) alone += kernel.LogScoreAtTruth(part);
  return kernel.LogScoreAtTruth(whole_) + alone / static_cast<double>(parts_.size());
}

}  // namespace walkgraph
