#include "solvers/baselines/dsff/error_block.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace walkgraph {
namespace {

double NormalCdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

}  // namespace

ErrorBlock::ErrorBlock(double sigma, const ErrorBlockSettings& settings)
    : sigma_(sigma), settings_(settings) {
  constexpr int kBins = 2;  // on either side of the middle
  const double whole = NormalCdf(kBins + 0.5) - NormalCdf(-kBins - 0.5);
  for (int bin = -kBins; bin <= kBins; ++bin) {
    mass_[bin] = (NormalCdf(bin + 0.5) - NormalCdf(bin - 0.5)) / whole;
  }
}

void ErrorBlock::Add(double error) {
  const bool aging = settings_.mode == ErrorBlockMode::kAging;
  const double added = aging ? settings_.alpha : settings_.block_mass / (1 + settings_.block_mass);
  for (auto& [bin, mass] : mass_) mass *= 1 - added;
  mass_[static_cast<int>(std::lround(error / sigma_))] += added;
}

double ErrorBlock::Mean() const {
  double mean = 0;
  for (const auto& [bin, mass] : mass_) mean += mass * bin;
  return mean * sigma_;
}

double ErrorBlock::Variance() const {
  const double mean = Mean() / sigma_;
  double variance = 1.0 / 12;  // within a bin
  for (const auto& [bin, mass] : mass_) variance += mass * (bin - mean) * (bin - mean);
  return variance * sigma_ * sigma_;
}

double ErrorBlock::MassWithin(double low, double high) const {
  double sum = 0;
  for (const auto& [bin, mass] : mass_) {
    const double from = std::max(low / sigma_, bin - 0.5);
    const double to = std::min(high / sigma_, bin + 0.5);
    sum += mass * std::max(0.0, to - from);
  }
  return sum;
}

double ErrorBlock::LogDensity(double deviation) const {
  // value = reading - error: the error that would explain it, in bins.
  const double error = -deviation / sigma_;
  double density = 0;
  for (const auto& [bin, mass] : mass_) {
    // Tails by the complement: a difference of two ones would be none.
    const double a = std::abs(error - bin);
    density +=
        mass * 0.5 *
        (std::erfc((a - 0.5) / std::numbers::sqrt2) - std::erfc((a + 0.5) / std::numbers::sqrt2));
  }
  return std::log(std::max(density, std::numeric_limits<double>::min())) - std::log(sigma_);
}

}  // namespace walkgraph
