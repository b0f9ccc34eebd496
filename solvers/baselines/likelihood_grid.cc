#include "solvers/baselines/likelihood_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "frontends/radio_map/sweeps.h"

namespace walkgraph {
namespace {

double ScanWeight(std::size_t readings, const RadioMap& map, const FingerprintSettings& settings) {
  const double n_eff = settings.n_eff > 0 ? settings.n_eff : map.n_eff;
  return n_eff > 0 ? std::min(1.0, n_eff / static_cast<double>(readings)) : 1.0;
}

TimeNs MeanHeard(const std::vector<MapSweep::Reading>& readings) {
  // Relative to the first: Unix nanoseconds are too large to sum.
  const TimeNs origin = readings.front().heard_ns;
  TimeNs sum = 0;
  for (const MapSweep::Reading& reading : readings) sum += reading.heard_ns - origin;
  return origin + sum / static_cast<TimeNs>(readings.size());
}

// Cuts a scan's readings (by heard_ns) into parts of equal duration and appends those not empty.
void AppendParts(const MapSweep& scan, double max_span_s, std::vector<MapSweep>* sweeps) {
  const TimeNs begin = scan.readings.front().heard_ns;
  const double span_s = SecondsBetween(begin, scan.readings.back().heard_ns);
  const int parts = span_s > max_span_s ? static_cast<int>(std::ceil(span_s / max_span_s)) : 1;
  std::vector<MapSweep::Reading> rest = scan.readings;
  auto first = rest.cbegin();
  for (int part = 1; part <= parts; ++part) {
    const TimeNs end = begin + DurationNs(span_s * part / parts);
    const auto last =
        part == parts ? rest.cend()
                      : std::find_if(first, rest.cend(), [end](const MapSweep::Reading& reading) {
                          return reading.heard_ns >= end;
                        });
    if (first == last) continue;
    MapSweep sweep = scan;
    sweep.readings.assign(first, last);
    sweep.mean_heard_ns = MeanHeard(sweep.readings);
    sweep.silence_share =
        static_cast<double>(sweep.readings.size()) / static_cast<double>(scan.readings.size());
    sweeps->push_back(std::move(sweep));
    first = last;
  }
}

struct NegativeLog {
  float mean_dbm = 0;
  float inverse_sigma = 0;
  float constant_nats = 0;  // log(sigma / sigma_min) - logit

  float At(float rssi_dbm) const {
    const float whitened = (rssi_dbm - mean_dbm) * inverse_sigma;
    return 0.5F * whitened * whitened + constant_nats;
  }
};

NegativeLog MakeNegativeLog(float mean_dbm, float log_sigma, float logit, float log_sigma_min) {
  return {mean_dbm, std::exp(-log_sigma), log_sigma - log_sigma_min - logit};
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

std::vector<MapSweep> CollectMapSweeps(const Site& site, const RadioMap& map,
                                       const Evidence& evidence,
                                       const FingerprintSettings& settings, double max_span_s) {
  const std::vector<std::int32_t> site_index = MatchTransmitters(site, evidence);
  std::vector<int> field_of(site_index.size(), -1);
  for (std::size_t i = 0; i < site_index.size(); ++i) {
    if (site_index[i] == kUnknownTransmitter) continue;
    field_of[i] = map.FindField(static_cast<std::uint32_t>(site_index[i]));
  }
  std::vector<MapSweep> sweeps;
  for (const Sweep& scan : GroupSweeps(evidence, map.radio)) {
    MapSweep known;
    known.radio = map.radio;
    for (const std::size_t i : scan.readings) {
      const RadioReading& reading = evidence.readings[i];
      if (field_of[reading.transmitter] < 0 || reading.rssi_dbm < settings.min_rssi_dbm) continue;
      known.readings.push_back({field_of[reading.transmitter], reading.rssi_dbm, reading.heard_ns});
    }
    if (known.readings.empty()) continue;
    known.weight = ScanWeight(known.readings.size(), map, settings);
    AppendParts(known, max_span_s, &sweeps);
  }
  std::stable_sort(sweeps.begin(), sweeps.end(), [](const MapSweep& a, const MapSweep& b) {
    return a.mean_heard_ns < b.mean_heard_ns;
  });
  return sweeps;
}

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
};

LikelihoodGrid::LikelihoodGrid(const RadioMap& map, std::span<const Eigen::Vector2d> positions_m)
    : map_(map), original_index_(positions_m.size()) {
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
    silence_nats_.push_back(static_cast<float>(map.Silence(basis, nullptr)));
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
  FieldSamples samples;
  samples.background = MakeNegativeLog(field.background_mean_dbm, field.background_log_sigma,
                                       field.background_logit_hear, log_sigma_min);
  for (const Segment& segment : segments) {
    for (std::size_t i = segment.begin; i < segment.end; ++i) {
      samples.at.push_back(MakeNegativeLog(mean.At(cell_[i], weights_[i]),
                                           log_sigma.At(cell_[i], weights_[i]),
                                           logit.At(cell_[i], weights_[i]), log_sigma_min));
    }
  }
  return samples;
}

std::vector<std::vector<float>> LikelihoodGrid::Evaluate(std::span<const MapSweep> sweeps) const {
  std::vector<Hearing> hearings;
  for (std::size_t s = 0; s < sweeps.size(); ++s) {
    for (const MapSweep::Reading& reading : sweeps[s].readings) {
      hearings.push_back({reading.field, s, reading.rssi_dbm});
    }
  }
  std::stable_sort(hearings.begin(), hearings.end(),
                   [](const Hearing& a, const Hearing& b) { return a.field < b.field; });

  // In sorted order: what a position differs from all transmitters at their background, which is
  // one constant per sweep.
  std::vector<std::vector<float>> sorted(sweeps.size(), std::vector<float>(cell_.size(), 0.0F));
  std::vector<double> background(sweeps.size(), 0.0);
  for (auto hearing = hearings.begin(); hearing != hearings.end();) {
    const RadioMap::TransmitterField& field = map_.fields[static_cast<std::size_t>(hearing->field)];
    const std::vector<Segment> segments = TouchedSegments(field);
    const FieldSamples samples = Sample(field, segments);
    for (const int current = hearing->field; hearing != hearings.end() && hearing->field == current;
         ++hearing) {
      const float constant = samples.background.At(hearing->rssi_dbm);
      background[hearing->sweep] += constant;
      const NegativeLog* at = samples.at.data();
      for (const Segment& segment : segments) {
        float* sum = sorted[hearing->sweep].data();
        for (std::size_t i = segment.begin; i < segment.end; ++i) {
          sum[i] += at++->At(hearing->rssi_dbm) - constant;
        }
      }
    }
  }

  std::vector<std::vector<float>> nats(sweeps.size(), std::vector<float>(cell_.size()));
  for (std::size_t s = 0; s < sweeps.size(); ++s) {
    const auto weight = static_cast<float>(sweeps[s].weight);
    const auto share = static_cast<float>(sweeps[s].silence_share);
    const auto constant = static_cast<float>(background[s]);
    for (std::size_t i = 0; i < cell_.size(); ++i) {
      nats[s][original_index_[i]] = weight * (sorted[s][i] + constant + share * silence_nats_[i]);
    }
  }
  return nats;
}

}  // namespace walkgraph
