#include "frontends/radio_map/magnetic_trainer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "frontends/radio_map/magnetic_kernel.h"
#include "frontends/radio_map/map_builder.h"
#include "frontends/radio_map/shift_posterior.h"

namespace walkgraph {
namespace {

constexpr double kGridM = 1.0;  // of the control points: steel bends the field over metres
constexpr std::size_t kMinTrials = 6;
constexpr std::size_t kFolds = 3;
constexpr std::size_t kPiecesPerFold = 40;
constexpr std::size_t kPartSamples = 10;  // 5 s
constexpr std::size_t kPieceParts = 4;
const ShiftGrid& Shifts() {
  static const ShiftGrid shifts(0.5, 8);
  return shifts;
}
constexpr std::array kCorrelationsS{0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0};
constexpr std::array kErrorsM{0.25, 0.5, 0.7, 1.0, 1.4, 2.0, 2.8, 4.0};

std::vector<PlacedField> SamplesOf(const Site& site, int floor) {
  std::vector<PlacedField> samples;
  for (const SurveyMagnetic& s : site.magnetic) {
    if (s.floor != floor) continue;
    samples.push_back({s.position_m.cast<double>(),
                       MagneticComponents({s.norm_ut, s.inclination_rad}), s.walk, s.trial});
  }
  return samples;
}

// Covers the samples and their kernels.
FieldGrid GridAround(const std::vector<PlacedField>& samples, double reach_m) {
  Eigen::Vector2d low = samples.front().position_m, high = low;
  for (const PlacedField& sample : samples) {
    low = low.cwiseMin(sample.position_m);
    high = high.cwiseMax(sample.position_m);
  }
  return GridOverBox(low.array() - reach_m, high.array() + reach_m, kGridM);
}

MagneticMap BuildMap(int floor, const KernelField& field, const KernelModel& model,
                     const Eigen::Array2d& sigma_scale) {
  MagneticMap map;
  map.floor = floor;
  map.grid = GridAround(field.samples(), model.reach_m());
  float min_log_sigma = std::numeric_limits<float>::infinity();
  for (int row = 0; row < map.grid.rows; ++row) {
    for (int column = 0; column < map.grid.columns; ++column) {
      const FieldDensity density =
          field.At(map.grid.origin_m + kGridM * Eigen::Vector2d(column, row), model);
      for (int c = 0; c < 2; ++c) {
        MagneticMap::Component& component = map.components[static_cast<std::size_t>(c)];
        component.mean_ut.push_back(static_cast<float>(density.mean_ut[c]));
        const double scale = std::pow(sigma_scale[c], density.known);
        const double sigma = scale * std::sqrt(density.variance_ut2[c]);
        component.log_sigma.push_back(static_cast<float>(std::log(sigma)));
        min_log_sigma = std::min(min_log_sigma, component.log_sigma.back());
      }
    }
  }
  map.sigma_min_ut = std::exp(static_cast<double>(min_log_sigma));
  return map;
}

// Five seconds of a walk: -log p of its samples by shift, each sample counted in full.
using Part = Eigen::ArrayXd;
using Piece = std::vector<Part>;  // up to 20 s

Part CostOverShifts(const MagneticMap& map, const PlacedField* begin, const PlacedField* end) {
  Part nats = Part::Zero(static_cast<Eigen::Index>(Shifts().size()));
  for (const PlacedField* sample = begin; sample != end; ++sample) {
    for (std::size_t i = 0; i < Shifts().size(); ++i) {
      const FieldBasis basis = EvaluateBasis(map.grid, sample->position_m + Shifts().At(i));
      for (int c = 0; c < 2; ++c) {
        const double log_sigma = map.LogSigma(c, basis).value;
        const double z = (sample->field_ut[c] - map.Mean(c, basis).value) * std::exp(-log_sigma);
        nats[static_cast<Eigen::Index>(i)] += 0.5 * z * z + log_sigma;
      }
    }
  }
  return nats;
}

// An even selection of the pieces of held-out walks, whose samples stand together.
void AppendPieces(const MagneticMap& map, const std::vector<PlacedField>& samples,
                  std::vector<Piece>* pieces) {
  constexpr std::size_t kPieceSamples = kPartSamples * kPieceParts;
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i + kPieceSamples <= samples.size();) {
    const bool whole = samples[i].walk == samples[i + kPieceSamples - 1].walk;
    if (whole) begins.push_back(i);
    i += whole ? kPieceSamples : 1;
  }
  const std::size_t step = begins.size() / kPiecesPerFold + 1;
  for (std::size_t k = 0; k < begins.size(); k += step) {
    Piece& piece = pieces->emplace_back();
    for (std::size_t part = 0; part < kPieceParts; ++part) {
      const PlacedField* begin = samples.data() + begins[k] + part * kPartSamples;
      piece.push_back(CostOverShifts(map, begin, begin + kPartSamples));
    }
  }
}

PiecePosterior Weighted(const Piece& piece, double weight) {
  std::vector<Part> parts;
  for (const Part& part : piece) parts.push_back(weight * part);
  return PiecePosterior(Shifts(), parts);
}

std::vector<Piece> HeldOutPieces(const std::vector<PlacedField>& samples,
                                 const std::set<std::uint32_t>& trials, const KernelModel& model,
                                 const Eigen::Array2d& sigma_scale) {
  std::map<std::uint32_t, std::size_t> fold_of;
  for (const std::uint32_t trial : trials) fold_of.emplace(trial, fold_of.size() % kFolds);
  std::vector<Piece> pieces;
  for (std::size_t fold = 0; fold < kFolds; ++fold) {
    std::vector<PlacedField> training, held_out;
    for (const PlacedField& sample : samples) {
      (fold_of.at(sample.trial) == fold ? held_out : training).push_back(sample);
    }
    AppendPieces(BuildMap(0, KernelField(training), model, sigma_scale), held_out, &pieces);
  }
  return pieces;
}

// The correlation time and the map error with the best score: neither too bold nor too timid wins.
void Calibrate(const std::vector<Piece>& pieces, MagneticMap* map) {
  double best_score = -std::numeric_limits<double>::infinity();
  SharedErrorKernels kernels(Shifts());
  for (const double correlation_s : kCorrelationsS) {
    std::vector<PiecePosterior> posteriors;
    for (const Piece& piece : pieces) {
      posteriors.push_back(Weighted(piece, kMagneticSampleS / correlation_s));
    }
    for (const double error_m : kErrorsM) {
      const SharedErrorKernel& kernel = kernels.At(error_m);
      double score = 0;
      for (const PiecePosterior& posterior : posteriors) score += posterior.Score(kernel);
      if (score <= best_score) continue;
      best_score = score;
      map->correlation_s = correlation_s;
      map->map_error_sigma_m = error_m;
    }
  }
}

std::optional<MagneticMap> TrainMap(const Site& site, int floor) {
  const std::vector<PlacedField> samples = SamplesOf(site, floor);
  std::set<std::uint32_t> trials;
  for (const PlacedField& sample : samples) trials.insert(sample.trial);
  if (trials.size() < kMinTrials) return std::nullopt;
  const KernelField field(samples);
  const KernelModel model = SelectKernelModel(field);
  const Eigen::Array2d sigma_scale = LeftOutSigmaScale(field, model);
  const std::vector<Piece> pieces = HeldOutPieces(samples, trials, model, sigma_scale);
  if (pieces.empty()) return std::nullopt;
  MagneticMap map = BuildMap(floor, field, model, sigma_scale);
  Calibrate(pieces, &map);
  return map;
}

}  // namespace

std::vector<MagneticMap> TrainMagneticMaps(const Site& site) {
  std::set<int> floors;
  for (const SurveyMagnetic& sample : site.magnetic) floors.insert(sample.floor);
  std::vector<MagneticMap> maps;
  for (const int floor : floors) {
    if (std::optional<MagneticMap> map = TrainMap(site, floor)) maps.push_back(std::move(*map));
  }
  return maps;
}

}  // namespace walkgraph
