#include "frontends/radio_map/shift_posterior.h"

#include <algorithm>
#include <cmath>

namespace walkgraph {
namespace {

// Chance that a piece lies where nothing is known: keeps one lost walk from deciding the score.
constexpr double kLostProbability = 0.02;

}  // namespace

SharedErrorKernel::SharedErrorKernel(const ShiftGrid& grid, double sigma_m) : grid_(grid) {
  double total = 0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    weight_.push_back(std::exp(-0.5 * grid.At(i).squaredNorm() / (sigma_m * sigma_m)));
    total += weight_.back();
  }
  for (double& weight : weight_) weight /= total;
}

double SharedErrorKernel::LogScoreAtTruth(const std::vector<double>& nats) const {
  const double lowest = *std::min_element(nats.begin(), nats.end());
  double total = 0, blurred = 0;
  for (std::size_t i = 0; i < nats.size(); ++i) {
    const double p = std::exp(lowest - nats[i]);
    total += p;
    blurred += p * weight_[i];
  }
  const double density = blurred / (total * grid_.cell_m2());
  const double lost = kLostProbability / (static_cast<double>(grid_.size()) * grid_.cell_m2());
  return std::log((1.0 - kLostProbability) * density + lost);
}

}  // namespace walkgraph
