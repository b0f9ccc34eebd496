#include "frontends/radio_map/hearing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace walkgraph {
namespace {

// No transmitter is certain to be heard or never heard: interference and power saving see to that.
constexpr double kMinProbability = 1e-4;
constexpr double kMaxProbability = 0.98;

constexpr double kKernelReachSquared = 16;  // in bandwidths

double Logit(double probability) {
  const double p = std::clamp(probability, kMinProbability, kMaxProbability);
  return std::log(p / (1.0 - p));
}

double MinusLogNotHeard(double logit) { return std::log1p(std::exp(logit)); }

Eigen::Vector2d ControlPoint(const FieldGrid& grid, int column, int row) {
  return grid.origin_m + grid.spacing_m * Eigen::Vector2d(column, row);
}

// Whole numbers from 0 to `count` that lie within `reach` of a place, and perhaps one more on
// either side.
struct Range {
  int first = 0, end = 0;
};
Range Within(double place, double reach, int count) {
  const auto inside = [count](double at) {
    return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(count)));
  };
  return {inside(std::floor(place - reach)), inside(std::ceil(place + reach) + 1)};
}

}  // namespace

HearingModel::HearingModel(const FieldGrid& grid, std::vector<Eigen::Vector2d> sweeps_m,
                           double bandwidth_m, double prior_sweeps)
    : grid_(grid),
      sweeps_m_(std::move(sweeps_m)),
      bandwidth_m_(bandwidth_m),
      prior_sweeps_(prior_sweeps) {
  std::vector<std::size_t> all(sweeps_m_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  sweep_count_ = Count(all, {0, 0, grid.columns, grid.rows});
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

std::vector<double> HearingModel::Count(const std::vector<std::size_t>& sweeps,
                                        const Rectangle& area) const {
  std::vector<double> count(static_cast<std::size_t>(area.columns) * area.rows, 0.0);
  const double reach = std::sqrt(kKernelReachSquared) * bandwidth_m_ / grid_.spacing_m;
  for (const std::size_t i : sweeps) {
    const Eigen::Vector2d at = (sweeps_m_[i] - grid_.origin_m) / grid_.spacing_m;
    const Range rows = Within(at.y() - area.row, reach, area.rows);
    const Range columns = Within(at.x() - area.column, reach, area.columns);
    for (int row = rows.first; row < rows.end; ++row) {
      for (int column = columns.first; column < columns.end; ++column) {
        count[static_cast<std::size_t>(row) * area.columns + column] +=
            Kernel(sweeps_m_[i], ControlPoint(grid_, area.column + column, area.row + row));
      }
    }
  }
  return count;
}

double HearingModel::Kernel(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
  const double squared = (a - b).squaredNorm() / (bandwidth_m_ * bandwidth_m_);
  return squared > kKernelReachSquared ? 0.0 : std::exp(-0.5 * squared);
}

void HearingModel::Fill(const std::vector<std::size_t>& heard,
                        RadioMap::TransmitterField* field) const {
  const double rate = static_cast<double>(heard.size()) /
                      static_cast<double>(std::max<std::size_t>(1, sweeps_m_.size()));
  field->background_logit_hear =
      static_cast<float>(Logit(prior_sweeps_ * rate / (median_count_ + prior_sweeps_)));
  field->logit_hear.clear();
  const std::vector<double> count =
      Count(heard, {field->column, field->row, field->columns, field->rows});
  for (int row = 0; row < field->rows; ++row) {
    for (int column = 0; column < field->columns; ++column) {
      const double near = count[static_cast<std::size_t>(row) * field->columns + column];
      const double all = sweep_count_[static_cast<std::size_t>(field->row + row) * grid_.columns +
                                      field->column + column];
      const double probability = (near + prior_sweeps_ * rate) / (all + prior_sweeps_);
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
