#include "frontends/radio_map/magnetic_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace walkgraph {
namespace {

constexpr double kMergeM = 0.5;
constexpr double kSquareM = 2.0;               // samples are found through squares of this side
constexpr double kMinSigmaUt = 0.3;            // resolution of phones' magnetometers
constexpr std::size_t kLeftOutSamples = 1000;  // that a model is chosen on; more change no choice
constexpr std::array kBandwidthsM{0.7, 1.0, 1.5, 2.5, 4.0};
constexpr std::array kPriorWeights{0.03, 0.1, 0.3, 1.0};

std::vector<PlacedField> Merge(const std::vector<PlacedField>& samples) {
  std::map<std::tuple<std::uint32_t, long, long>, std::pair<PlacedField, int>> cells;
  for (const PlacedField& sample : samples) {
    const Eigen::Vector2d cell = sample.position_m / kMergeM;
    auto& [sum, count] = cells[{sample.walk, std::lround(cell.x()), std::lround(cell.y())}];
    sum.position_m += sample.position_m;
    sum.field_ut += sample.field_ut;
    sum.walk = sample.walk;
    sum.trial = sample.trial;
    ++count;
  }
  std::vector<PlacedField> merged;
  for (auto& [key, cell] : cells) {
    cell.first.position_m /= cell.second;
    cell.first.field_ut /= cell.second;
    merged.push_back(cell.first);
  }
  return merged;
}

Eigen::Array2d Whitened(const PlacedField& sample, const FieldDensity& density) {
  return (sample.field_ut.array() - density.mean_ut) / density.variance_ut2.sqrt();
}

// Every so many of the samples are left out in turn.
std::size_t LeftOutStep(const KernelField& field) {
  return std::max<std::size_t>(1, field.samples().size() / kLeftOutSamples);
}

double LeftOutLogDensity(const KernelField& field, const KernelModel& model) {
  const std::vector<PlacedField>& samples = field.samples();
  double sum = 0;
  for (std::size_t i = 0; i < samples.size(); i += LeftOutStep(field)) {
    const FieldDensity density = field.At(samples[i].position_m, model, samples[i].trial);
    sum -= 0.5 * (Whitened(samples[i], density).square() + density.variance_ut2.log()).sum();
  }
  return sum;
}

}  // namespace

KernelField::KernelField(const std::vector<PlacedField>& samples) : samples_(Merge(samples)) {
  Eigen::Vector2d high = samples_.front().position_m;
  origin_m_ = high;
  for (const PlacedField& sample : samples_) {
    origin_m_ = origin_m_.cwiseMin(sample.position_m);
    high = high.cwiseMax(sample.position_m);
    floor_.mean_ut += sample.field_ut.array();
  }
  squares_ = SquareOf(high) + 1;
  in_square_.resize(static_cast<std::size_t>(squares_.prod()));
  floor_.mean_ut /= static_cast<double>(samples_.size());
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Eigen::Array2i square = SquareOf(samples_[i].position_m);
    in_square_[static_cast<std::size_t>(square.y() * squares_.x() + square.x())].push_back(
        static_cast<std::uint32_t>(i));
    floor_.variance_ut2 += (samples_[i].field_ut.array() - floor_.mean_ut).square();
  }
  floor_.variance_ut2 /= static_cast<double>(samples_.size());
  floor_.variance_ut2 = floor_.variance_ut2.max(kMinSigmaUt * kMinSigmaUt);
}

FieldDensity KernelField::At(const Eigen::Vector2d& place, const KernelModel& model,
                             std::optional<std::uint32_t> left_out) const {
  const double reach_m = model.reach_m();
  const double scale = -0.5 / (model.bandwidth_m * model.bandwidth_m);
  // Deviations from the floor's mean: the pseudo-sample has none.
  double weight = model.prior_weight;
  Eigen::Array2d sum = Eigen::Array2d::Zero();
  Eigen::Array2d squares = model.prior_weight * floor_.variance_ut2;
  const Eigen::Array2i first = SquareOf(place.array() - reach_m).max(0);
  const Eigen::Array2i last = SquareOf(place.array() + reach_m).min(squares_ - 1);
  for (int y = first.y(); y <= last.y(); ++y) {
    for (int x = first.x(); x <= last.x(); ++x) {
      for (const std::uint32_t i : in_square_[static_cast<std::size_t>(y * squares_.x() + x)]) {
        const PlacedField& sample = samples_[i];
        const double squared_m2 = (sample.position_m - place).squaredNorm();
        if (squared_m2 > reach_m * reach_m || sample.trial == left_out) continue;
        const double kernel = std::exp(scale * squared_m2);
        const Eigen::Array2d deviation = sample.field_ut.array() - floor_.mean_ut;
        weight += kernel;
        sum += kernel * deviation;
        squares += kernel * deviation.square();
      }
    }
  }
  const Eigen::Array2d mean = sum / weight;
  return {floor_.mean_ut + mean, (squares / weight - mean.square()).max(kMinSigmaUt * kMinSigmaUt),
          1.0 - model.prior_weight / weight};
}

Eigen::Array2i KernelField::SquareOf(const Eigen::Vector2d& place) const {
  return ((place - origin_m_).array() / kSquareM).floor().cast<int>();
}

KernelModel SelectKernelModel(const KernelField& field) {
  KernelModel best;
  double best_density = -std::numeric_limits<double>::infinity();
  for (const double bandwidth_m : kBandwidthsM) {
    for (const double prior_weight : kPriorWeights) {
      const KernelModel model{bandwidth_m, prior_weight};
      const double density = LeftOutLogDensity(field, model);
      if (density <= best_density) continue;
      best_density = density;
      best = model;
    }
  }
  return best;
}

Eigen::Array2d LeftOutSigmaScale(const KernelField& field, const KernelModel& model) {
  Eigen::Array2d squares = Eigen::Array2d::Zero();
  double count = 0;
  for (std::size_t i = 0; i < field.samples().size(); i += LeftOutStep(field)) {
    const PlacedField& sample = field.samples()[i];
    squares += Whitened(sample, field.At(sample.position_m, model, sample.trial)).square();
    ++count;
  }
  return (squares / count).sqrt();
}

}  // namespace walkgraph
