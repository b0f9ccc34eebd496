#include "frontends/radio_map/hearing.h"

#include <algorithm>
#include <cmath>

namespace walkgraph {
namespace {

// No transmitter is certain to be heard or never heard: interference and power saving see to that.
constexpr double kMinProbability = 1e-4;
constexpr double kMaxProbability = 0.98;

double Logit(double probability) {
  const double p = std::clamp(probability, kMinProbability, kMaxProbability);
  return std::log(p / (1.0 - p));
}

double MinusLogNotHeard(double logit) { return std::log1p(std::exp(logit)); }

Eigen::Vector2d ControlPoint(const FieldGrid& grid, int column, int row) {
  return grid.origin_m + grid.spacing_m * Eigen::Vector2d(column, row);
}

}  // namespace

HearingModel::HearingModel(const FieldGrid& grid, std::vector<Eigen::Vector2d> sweeps_m,
                           double bandwidth_m, double prior_sweeps)
    : grid_(grid),
      sweeps_m_(std::move(sweeps_m)),
      bandwidth_m_(bandwidth_m),
      prior_sweeps_(prior_sweeps) {
  sweep_count_.reserve(static_cast<std::size_t>(grid.columns) * grid.rows);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const Eigen::Vector2d at = ControlPoint(grid, column, row);
      double count = 0;
      for (const Eigen::Vector2d& sweep : sweeps_m_) count += Kernel(sweep, at);
      sweep_count_.push_back(count);
    }
  }
  std::vector<double> visited;
  for (const double count : sweep_count_) {
    if (count >= 1.0) visited.push_back(count);
  }
  if (!visited.empty()) {
    const auto middle = visited.begin() + static_cast<std::ptrdiff_t>(visited.size() / 2);
    std::nth_element(visited.begin(), middle, visited.end());
    median_count_ = *middle;
  }
}

double HearingModel::Kernel(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
  const double squared = (a - b).squaredNorm() / (bandwidth_m_ * bandwidth_m_);
  return squared > 16.0 ? 0.0 : std::exp(-0.5 * squared);
}

void HearingModel::Fill(const std::vector<std::size_t>& heard,
                        RadioMap::TransmitterField* field) const {
  const double rate = static_cast<double>(heard.size()) /
                      static_cast<double>(std::max<std::size_t>(1, sweeps_m_.size()));
  field->background_logit_hear =
      static_cast<float>(Logit(prior_sweeps_ * rate / (median_count_ + prior_sweeps_)));
  field->logit_hear.clear();
  for (int row = field->row; row < field->row + field->rows; ++row) {
    for (int column = field->column; column < field->column + field->columns; ++column) {
      const Eigen::Vector2d at = ControlPoint(grid_, column, row);
      double count = 0;
      for (const std::size_t i : heard) count += Kernel(sweeps_m_[i], at);
      const double all = sweep_count_[static_cast<std::size_t>(row) * grid_.columns + column];
      const double probability = (count + prior_sweeps_ * rate) / (all + prior_sweeps_);
      field->logit_hear.push_back(static_cast<float>(Logit(probability)));
    }
  }
}

std::vector<float> SilenceField(const FieldGrid& grid,
                                const std::vector<RadioMap::TransmitterField>& fields) {
  double background = 0;
  for (const RadioMap::TransmitterField& f : fields) {
    background += MinusLogNotHeard(f.background_logit_hear);
  }
  std::vector<double> sum(static_cast<std::size_t>(grid.columns) * grid.rows, background);
  for (const RadioMap::TransmitterField& f : fields) {
    const double own_background = MinusLogNotHeard(f.background_logit_hear);
    for (int row = 0; row < f.rows; ++row) {
      for (int column = 0; column < f.columns; ++column) {
        const double value =
            MinusLogNotHeard(f.logit_hear[static_cast<std::size_t>(row) * f.columns + column]);
        sum[static_cast<std::size_t>(f.row + row) * grid.columns + f.column + column] +=
            value - own_background;
      }
    }
  }
  return {sum.begin(), sum.end()};
}

}  // namespace walkgraph
