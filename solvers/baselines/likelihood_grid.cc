#include "solvers/baselines/likelihood_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "factors/loss.h"

namespace walkgraph {
namespace {

// What a sweep's readings sum up to at a position: -log p without offset, and its first and
// (negative) second derivative by a common offset.
struct Terms {
  float nats = 0;
  float slope = 0;
  float information = 0;

  Terms& operator+=(const Terms& other) {
    nats += other.nats;
    slope += other.slope;
    information += other.information;
    return *this;
  }
  friend Terms operator-(const Terms& a, const Terms& b) {
    return {a.nats - b.nats, a.slope - b.slope, a.information - b.information};
  }
};

struct NegativeLog {
  float mean_dbm = 0;
  float inverse_sigma = 0;
  float constant_nats = 0;  // log(sigma / sigma_min) - h logit

  Terms At(float rssi_dbm, float root_precision, const LossSettings& loss) const {
    const float inverse = root_precision * inverse_sigma;
    const RobustCost cost = CostUnderLoss(loss, (rssi_dbm - mean_dbm) * inverse);
    return {cost.nats + constant_nats, cost.slope * inverse, cost.weight * inverse * inverse};
  }
};

NegativeLog MakeNegativeLog(float mean_dbm, float log_sigma, float weighted_logit,
                            float log_sigma_min) {
  return {mean_dbm, std::exp(-log_sigma), log_sigma - log_sigma_min - weighted_logit};
}

// -log p with the offset integrated out.
float IntegrateOffset(const Terms& terms, float variance_db2) {
  if (variance_db2 <= 0) return terms.nats;
  const float spread = 1.0F + variance_db2 * terms.information;
  return terms.nats - 0.5F * variance_db2 * terms.slope * terms.slope / spread +
         0.5F * std::log(spread);
}

// A transmitter's control values with a margin of three background points, so that every window of
// 4 x 4 that touches the rectangle lies inside.
class PaddedControls {
 public:
  PaddedControls(const RadioMap::TransmitterField& field, const std::vector<float>& values,
                 float background)
      : row_(field.row - 3),
        column_(field.column - 3),
        columns_(field.columns + 6),
        values_(static_cast<std::size_t>(columns_) * (field.rows + 6), background) {
    for (int r = 0; r < field.rows; ++r) {
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(r) * field.columns, field.columns,
                  values_.begin() + static_cast<std::ptrdiff_t>(r + 3) * columns_ + 3);
    }
  }
  // The window whose first control point is (row, column) of the map's grid.
  float At(const std::array<int, 2>& cell, const std::array<float, 16>& weights) const {
    const float* window = values_.data() + static_cast<std::ptrdiff_t>(cell[0] - row_) * columns_ +
                          (cell[1] - column_);
    Eigen::Array4f sum = Eigen::Array4f::Zero();
    for (int r = 0; r < 4; ++r) {
      sum += Eigen::Map<const Eigen::Array4f>(weights.data() + std::ptrdiff_t{4} * r) *
             Eigen::Map<const Eigen::Array4f>(window + static_cast<std::ptrdiff_t>(r) * columns_);
    }
    return sum.sum();
  }

 private:
  int row_, column_, columns_;
  std::vector<float> values_;
};

}  // namespace

// One transmitter at the positions of its segments, one after the other.
struct LikelihoodGrid::FieldSamples {
  std::vector<NegativeLog> at;
  NegativeLog background;
};

// One reading of one field in one of the sweeps.
struct LikelihoodGrid::Hearing {
  int field = 0;
  std::size_t sweep = 0;
  float rssi_dbm = 0;
  float root_precision = 1;
};

LikelihoodGrid::LikelihoodGrid(const RadioMap& map, std::span<const Eigen::Vector2d> positions_m,
                               const RssiOffsetPrior& offset, const LossSettings& loss)
    : map_(map), offset_(offset), loss_(loss), original_index_(positions_m.size()) {
  std::vector<FieldBasis> bases;
  bases.reserve(positions_m.size());
  for (const Eigen::Vector2d& position : positions_m) {
    bases.push_back(EvaluateBasis(map.grid, position));
  }
  std::iota(original_index_.begin(), original_index_.end(), std::size_t{0});
  std::stable_sort(
      original_index_.begin(), original_index_.end(), [&bases](std::size_t a, std::size_t b) {
        return std::pair(bases[a].row, bases[a].column) < std::pair(bases[b].row, bases[b].column);
      });
  for (const std::size_t index : original_index_) {
    const FieldBasis& basis = bases[index];
    cell_.push_back({basis.row, basis.column});
    std::array<float, 16>& weights = weights_.emplace_back();
    std::transform(basis.weight.begin(), basis.weight.end(), weights.begin(),
                   [](double weight) { return static_cast<float>(weight); });
    silence_nats_.push_back(static_cast<float>(map.Silence(basis).value));
  }
}

std::vector<LikelihoodGrid::Segment> LikelihoodGrid::TouchedSegments(
    const RadioMap::TransmitterField& field) const {
  std::vector<Segment> segments;
  if (field.rows == 0 || field.columns == 0) return segments;
  for (int row = field.row - 3; row < field.row + field.rows; ++row) {
    const auto begin =
        std::lower_bound(cell_.begin(), cell_.end(), std::array<int, 2>{row, field.column - 3});
    const auto end =
        std::lower_bound(begin, cell_.end(), std::array<int, 2>{row, field.column + field.columns});
    if (begin == end) continue;
    segments.push_back({static_cast<std::size_t>(begin - cell_.begin()),
                        static_cast<std::size_t>(end - cell_.begin())});
  }
  return segments;
}

LikelihoodGrid::FieldSamples LikelihoodGrid::Sample(const RadioMap::TransmitterField& field,
                                                    const std::vector<Segment>& segments) const {
  const auto log_sigma_min = static_cast<float>(std::log(map_.sigma_min_db));
  const PaddedControls mean(field, field.mean_dbm, field.background_mean_dbm);
  const PaddedControls log_sigma(field, field.log_sigma, field.background_log_sigma);
  const PaddedControls logit(field, field.logit_hear, field.background_logit_hear);
  const auto hear_weight = static_cast<float>(map_.hear_weight);
  FieldSamples samples;
  samples.background = MakeNegativeLog(field.background_mean_dbm, field.background_log_sigma,
                                       hear_weight * field.background_logit_hear, log_sigma_min);
  for (const Segment& segment : segments) {
    for (std::size_t i = segment.begin; i < segment.end; ++i) {
      samples.at.push_back(
          MakeNegativeLog(mean.At(cell_[i], weights_[i]), log_sigma.At(cell_[i], weights_[i]),
                          hear_weight * logit.At(cell_[i], weights_[i]), log_sigma_min));
    }
  }
  return samples;
}

std::vector<std::vector<float>> LikelihoodGrid::Evaluate(std::span<const MapSweep> sweeps) const {
  const auto mean_offset_db = static_cast<float>(offset_.mean_db);
  std::vector<Hearing> hearings;
  for (std::size_t s = 0; s < sweeps.size(); ++s) {
    for (const MapSweep::Reading& reading : sweeps[s].readings) {
      hearings.push_back(
          {reading.field, s, reading.rssi_dbm + mean_offset_db, std::sqrt(reading.precision)});
    }
  }
  std::stable_sort(hearings.begin(), hearings.end(),
                   [](const Hearing& a, const Hearing& b) { return a.field < b.field; });

  // In sorted order: what a position differs from all transmitters at their background, which is
  // one constant per sweep.
  std::vector<std::vector<Terms>> sorted(sweeps.size(), std::vector<Terms>(cell_.size()));
  std::vector<Terms> background(sweeps.size());
  for (auto hearing = hearings.begin(); hearing != hearings.end();) {
    const RadioMap::TransmitterField& field = map_.fields[static_cast<std::size_t>(hearing->field)];
    const std::vector<Segment> segments = TouchedSegments(field);
    const FieldSamples samples = Sample(field, segments);
    for (const int current = hearing->field; hearing != hearings.end() && hearing->field == current;
         ++hearing) {
      const float rssi_dbm = hearing->rssi_dbm, root_precision = hearing->root_precision;
      const Terms constant = samples.background.At(rssi_dbm, root_precision, loss_);
      background[hearing->sweep] += constant;
      const NegativeLog* at = samples.at.data();
      for (const Segment& segment : segments) {
        Terms* sum = sorted[hearing->sweep].data();
        for (std::size_t i = segment.begin; i < segment.end; ++i) {
          sum[i] += at++->At(rssi_dbm, root_precision, loss_) - constant;
        }
      }
    }
  }

  std::vector<std::vector<float>> nats(sweeps.size(), std::vector<float>(cell_.size()));
  for (std::size_t s = 0; s < sweeps.size(); ++s) {
    const auto weight = static_cast<float>(sweeps[s].weight);
    const auto share = static_cast<float>(map_.hear_weight * sweeps[s].silence_share);
    const auto variance = static_cast<float>(offset_.sigma_db * offset_.sigma_db);
    for (std::size_t i = 0; i < cell_.size(); ++i) {
      sorted[s][i] += background[s];
      nats[s][original_index_[i]] =
          weight * (IntegrateOffset(sorted[s][i], variance) + share * silence_nats_[i]);
    }
  }
  return nats;
}

}  // namespace walkgraph
