#include "factors/magnetic.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "factors/cost.h"
#include "factors/cost_row.h"

namespace walkgraph {

std::vector<MagneticLook> CollectMagneticLooks(const Site& site, const Evidence& evidence,
                                               const MagneticLookSettings& settings,
                                               const FloorPath& floors) {
  std::vector<MagneticLook> looks;
  if (!settings.enabled || site.magnetic_maps.empty()) return looks;
  const TimeNs span_ns = DurationNs(kMagneticSampleS);
  for (TimeNs begin = evidence.begin_ns; begin < evidence.end_ns; begin += span_ns) {
    const TimeNs middle = begin + span_ns / 2;
    const MagneticMap* map = site.FindMagneticMap(floors.At(middle));
    if (map == nullptr || MotionStateAt(evidence, middle) == MotionState::kHandling) continue;
    const std::optional<MagneticSample> mean = MeanField(evidence.magnetic, begin, begin + span_ns);
    if (!mean) continue;
    const double correlation_s =
        settings.correlation_s > 0 ? settings.correlation_s : map->correlation_s;
    looks.push_back({std::min(middle, evidence.end_ns), map, MagneticComponents(*mean),
                     std::min(1.0, kMagneticSampleS / correlation_s)});
  }
  return looks;
}

bool MagneticFactor::Evaluate(const double* const* blocks, double* residual,
                              double** jacobians) const {
  const MagneticMap& map = *look_.map;
  const FieldBasis basis =
      EvaluateBasis(map.grid, {blocks[0][0] + blocks[1][0], blocks[0][1] + blocks[1][1]});
  const double root_weight = std::sqrt(look_.weight);
  const double log_sigma_min = std::log(map.sigma_min_ut);
  const auto fill = [jacobians](int row, const Eigen::Vector2d& gradient) {
    for (int block = 0; jacobians != nullptr && block < 2; ++block) {
      if (jacobians[block] == nullptr) continue;
      Eigen::Map<Eigen::Vector2d>(jacobians[block] + std::ptrdiff_t{2} * row) = gradient;
    }
  };
  ScalarValue spread;
  for (int c = 0; c < kComponents; ++c) {
    const ScalarValue mean = map.Mean(c, basis);
    const ScalarValue log_sigma = map.LogSigma(c, basis);
    const double information = root_weight * std::exp(-log_sigma.value);
    residual[c] = (look_.field_ut[c] - mean.value) * information;
    fill(c, -information * mean.gradient - residual[c] * log_sigma.gradient);
    spread.value += log_sigma.value - log_sigma_min;
    spread.gradient += log_sigma.gradient;
  }
  const CostRow row(spread.value, look_.weight);
  residual[kComponents] = row.value;
  fill(kComponents, row.slope * spread.gradient);
  return true;
}

double MagneticFactor::CostConstant() const { return 0.5 * look_.weight * kRowOffset; }

double MagneticFactor::LogNormaliser() const {
  return look_.weight * kComponents * GaussianLogNormaliser(look_.map->sigma_min_ut);
}

MagneticGrid::MagneticGrid(const MagneticMap& map, const std::vector<Eigen::Vector2d>& places_m) {
  const double log_sigma_min = std::log(map.sigma_min_ut);
  for (const Eigen::Vector2d& place_m : places_m) {
    const FieldBasis basis = EvaluateBasis(map.grid, place_m);
    Place& place = places_.emplace_back();
    for (int c = 0; c < MagneticFactor::kComponents; ++c) {
      const double log_sigma = map.LogSigma(c, basis).value;
      place.mean_ut[c] = static_cast<float>(map.Mean(c, basis).value);
      place.information[c] = static_cast<float>(std::exp(-log_sigma));
      place.spread_nats += static_cast<float>(log_sigma - log_sigma_min);
    }
  }
}

std::vector<float> MagneticGrid::Evaluate(const MagneticLook& look) const {
  const Eigen::Array2f field_ut = look.field_ut.cast<float>().array();
  const auto weight = static_cast<float>(look.weight);
  std::vector<float> nats;
  nats.reserve(places_.size());
  for (const Place& place : places_) {
    const float squared = ((field_ut - place.mean_ut) * place.information).square().sum();
    nats.push_back(weight * (0.5F * squared + place.spread_nats));
  }
  return nats;
}

}  // namespace walkgraph
