#include "solvers/baselines/likelihood_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "factors/loss.h"
#include "frontends/radio_map/body_shadow.h"

namespace walkgraph {
namespace {

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

// What readings sum up to at each position: -log p without offset, and its first and (negative)
// second derivative by a common offset.
struct LikelihoodGrid::Terms {
  explicit Terms(Eigen::Index size)
      : nats(Eigen::ArrayXf::Zero(size)),
        slope(Eigen::ArrayXf::Zero(size)),
        information(Eigen::ArrayXf::Zero(size)) {}

  // -log p with the offset integrated out.
  Eigen::ArrayXf IntegrateOffset(float variance_db2) const {
    if (variance_db2 <= 0) return nats;
    const Eigen::ArrayXf spread = 1.0F + variance_db2 * information;
    return nats - 0.5F * variance_db2 * slope.square() / spread + 0.5F * spread.log();
  }

  Eigen::ArrayXf nats, slope, information;
};

// One reading of one field in one of the sweeps.
struct LikelihoodGrid::Hearing {
  int field = 0;
  std::size_t sweep = 0;
  float rssi_dbm = 0;
  float root_precision = 1;
  Eigen::Vector2f shadow_db = Eigen::Vector2f::Zero();  // towards where the walker faces
};

// One transmitter at the positions of its segments, one after the other, and then its background.
struct LikelihoodGrid::FieldSamples {
  explicit FieldSamples(Eigen::Index size)
      : mean_dbm(size), inverse_sigma(size), constant_nats(size) {}

  // Of one reading, `shadow` (dB) times the bearing stronger than the mean.
  void Evaluate(const Hearing& hearing, const LossSettings& loss, Terms* terms) const {
    terms->slope = hearing.root_precision * inverse_sigma;
    if (hearing.shadow_db.isZero()) {
      terms->nats = (hearing.rssi_dbm - mean_dbm) * terms->slope;  // whitened
    } else {
      terms->nats = (hearing.rssi_dbm - mean_dbm - hearing.shadow_db.x() * bearing_x -
                     hearing.shadow_db.y() * bearing_y) *
                    terms->slope;
    }
    terms->information = terms->slope.square();
    if (!IsForRows(loss)) {
      terms->slope *= terms->nats;
      terms->nats = 0.5F * terms->nats.square() + constant_nats;
      return;
    }
    for (Eigen::Index i = 0; i < mean_dbm.size(); ++i) {
      const RobustCost cost = CostUnderLoss(loss, terms->nats[i]);
      terms->nats[i] = cost.nats + constant_nats[i];
      terms->slope[i] *= cost.slope;
      terms->information[i] *= cost.weight;
    }
  }

  Eigen::ArrayXf mean_dbm, inverse_sigma;
  Eigen::ArrayXf bearing_x, bearing_y;  // of the transmitter; where the map has shadows
  Eigen::ArrayXf constant_nats;         // log(sigma / sigma_min) - h logit
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
  x_m_.resize(static_cast<Eigen::Index>(positions_m.size()));
  y_m_.resize(x_m_.size());
  for (const std::size_t index : original_index_) {
    const auto sorted = static_cast<Eigen::Index>(cell_.size());
    x_m_[sorted] = static_cast<float>(positions_m[index].x());
    y_m_[sorted] = static_cast<float>(positions_m[index].y());
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
  const PaddedControls mean(field, field.mean_dbm, field.background_mean_dbm);
  const PaddedControls log_sigma(field, field.log_sigma, field.background_log_sigma);
  const PaddedControls logit(field, field.logit_hear, field.background_logit_hear);
  Eigen::Index size = 1;
  for (const Segment& segment : segments) size += segment.size();
  FieldSamples samples(size);
  Eigen::ArrayXf log_sigmas(size), logits(size);
  Eigen::Index at = 0;
  for (const Segment& segment : segments) {
    for (std::size_t i = segment.begin; i < segment.end; ++i, ++at) {
      samples.mean_dbm[at] = mean.At(cell_[i], weights_[i]);
      log_sigmas[at] = log_sigma.At(cell_[i], weights_[i]);
      logits[at] = logit.At(cell_[i], weights_[i]);
    }
  }
  if (map_.body_shadow_db != 0) AddBearings(field, segments, &samples);
  samples.mean_dbm[at] = field.background_mean_dbm;
  log_sigmas[at] = field.background_log_sigma;
  logits[at] = field.background_logit_hear;
  samples.inverse_sigma = (-log_sigmas).exp();
  samples.constant_nats = log_sigmas - static_cast<float>(std::log(map_.sigma_min_db)) -
                          static_cast<float>(map_.hear_weight) * logits;
  return samples;
}

// The background has none: from far away, where nobody heard it, nothing is known of a direction.
void LikelihoodGrid::AddBearings(const RadioMap::TransmitterField& field,
                                 const std::vector<Segment>& segments,
                                 FieldSamples* samples) const {
  samples->bearing_x.setZero(samples->mean_dbm.size());
  samples->bearing_y.setZero(samples->mean_dbm.size());
  constexpr auto kSoftness = static_cast<float>(kBearingSoftness);
  Eigen::Index at = 0;
  for (const Segment& segment : segments) {
    const auto begin = static_cast<Eigen::Index>(segment.begin);
    const Eigen::Index size = segment.size();
    auto x = samples->bearing_x.segment(at, size), y = samples->bearing_y.segment(at, size);
    x = field.source_m.x() - x_m_.segment(begin, size);
    y = field.source_m.y() - y_m_.segment(begin, size);
    const Eigen::ArrayXf inverse = (x.square() + y.square() + kSoftness * kSoftness).rsqrt();
    x *= inverse;
    y *= inverse;
    at += size;
  }
}

std::vector<std::vector<float>> LikelihoodGrid::Evaluate(std::span<const MapSweep> sweeps) const {
  const auto mean_offset_db = static_cast<float>(offset_.mean_db);
  std::vector<Hearing> hearings;
  for (std::size_t s = 0; s < sweeps.size(); ++s) {
    for (const MapSweep::Reading& reading : sweeps[s].readings) {
      hearings.push_back({reading.field, s, reading.rssi_dbm + mean_offset_db,
                          std::sqrt(reading.precision),
                          (map_.body_shadow_db * sweeps[s].facing).cast<float>()});
    }
  }
  std::stable_sort(hearings.begin(), hearings.end(),
                   [](const Hearing& a, const Hearing& b) { return a.field < b.field; });

  // In sorted order: what a position differs from all transmitters at their background, which is
  // one constant per sweep.
  const auto places = static_cast<Eigen::Index>(cell_.size());
  std::vector<Terms> sorted(sweeps.size(), Terms(places));
  std::vector<Terms> background(sweeps.size(), Terms(1));
  Terms terms(0);
  for (auto hearing = hearings.begin(); hearing != hearings.end();) {
    const RadioMap::TransmitterField& field = map_.fields[static_cast<std::size_t>(hearing->field)];
    const std::vector<Segment> segments = TouchedSegments(field);
    const FieldSamples samples = Sample(field, segments);
    for (const int current = hearing->field; hearing != hearings.end() && hearing->field == current;
         ++hearing) {
      samples.Evaluate(*hearing, loss_, &terms);
      AddDifferences(terms, segments, &sorted[hearing->sweep], &background[hearing->sweep]);
    }
  }

  std::vector<std::vector<float>> nats(sweeps.size(), std::vector<float>(cell_.size()));
  const auto silence = Eigen::ArrayXf::Map(silence_nats_.data(), places);
  for (std::size_t s = 0; s < sweeps.size(); ++s) {
    const auto weight = static_cast<float>(sweeps[s].weight);
    const auto share = static_cast<float>(map_.hear_weight * sweeps[s].silence_share);
    const auto variance = static_cast<float>(offset_.sigma_db * offset_.sigma_db);
    sorted[s].nats += background[s].nats[0];
    sorted[s].slope += background[s].slope[0];
    sorted[s].information += background[s].information[0];
    const Eigen::ArrayXf cost = weight * (sorted[s].IntegrateOffset(variance) + share * silence);
    for (std::size_t i = 0; i < cell_.size(); ++i) {
      nats[s][original_index_[i]] = cost[static_cast<Eigen::Index>(i)];
    }
  }
  return nats;
}

// Of one reading: the background's own, which comes last, and what each place differs from it.
void LikelihoodGrid::AddDifferences(const Terms& terms, const std::vector<Segment>& segments,
                                    Terms* sums, Terms* background) {
  const Eigen::Index last = terms.nats.size() - 1;
  background->nats[0] += terms.nats[last];
  background->slope[0] += terms.slope[last];
  background->information[0] += terms.information[last];
  Eigen::Index at = 0;
  for (const Segment& segment : segments) {
    const auto begin = static_cast<Eigen::Index>(segment.begin);
    const Eigen::Index size = segment.size();
    sums->nats.segment(begin, size) += terms.nats.segment(at, size) - terms.nats[last];
    sums->slope.segment(begin, size) += terms.slope.segment(at, size) - terms.slope[last];
    sums->information.segment(begin, size) +=
        terms.information.segment(at, size) - terms.information[last];
    at += size;
  }
}

}  // namespace walkgraph
