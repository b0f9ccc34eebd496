#include "frontends/radio_map/map_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <span>

#include "frontends/radio_map/shift_posterior.h"

namespace walkgraph {
namespace {

constexpr std::size_t kFolds = 3;
constexpr std::size_t kMinWalks = 6;
constexpr std::size_t kWalksPerFold = 16;
constexpr std::size_t kAllWalks = std::numeric_limits<std::size_t>::max();
// The search for a model and calibration see this many transmitters of a floor, and samples of
// each, at most: a hundred walks are to be trained on in seconds.
constexpr std::size_t kSearchTransmitters = 150;
constexpr std::size_t kCalibrationTransmitters = 400;
constexpr std::size_t kSearchSamples = 120;
constexpr double kPieceSeconds = 20;
constexpr ShiftGrid kShifts(2.5, 8);

// A coarse grid compares field models and hearing weights, the fine one sets the numbers.
constexpr std::array kCoarseNEff{1.0, 3.0, 9.0};
constexpr std::array kCoarseMapErrors{1.4, 2.8};
constexpr std::array kNEff{0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 9.0, 13.0, 20.0};
constexpr std::array kHearWeights{0.2, 0.4, 0.7, 1.0};
constexpr std::array kMapErrors{0.7, 1.0, 1.4, 2.0, 2.8, 4.0, 5.6, 8.0};

// -log p of a scan, moved by every shift: of its signal strengths, and of what it heard and missed.
struct ScanCost {
  TimeNs time_ns = 0;
  std::size_t readings = 0;
  std::vector<double> signal_nats;
  std::vector<double> hearing_nats;
};

Eigen::Vector2d MeanPosition(const SurveyScan& scan) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const SurveyReading& reading : scan.readings) sum += reading.position_m.cast<double>();
  return sum / static_cast<double>(scan.readings.size());
}

// What the best common offset of a scan's readings takes off its cost: the phone held against the
// body hears everything weaker. Normal prior, integrated out.
double OffsetGain(double slope, double information, const TrainerSettings& settings) {
  const double variance = settings.rssi_offset_sigma_db * settings.rssi_offset_sigma_db;
  const double spread = 1.0 + variance * information;
  return 0.5 * variance * slope * slope / spread - 0.5 * std::log(spread);
}

ScanCost CostOverShifts(const RadioMap& map, const SurveyScan& scan,
                        const TrainerSettings& settings) {
  ScanCost cost;
  cost.time_ns = scan.printed_ns;
  // The spread of a scan's readings along the walk matters less than the grid of shifts.
  const Eigen::Vector2d center = MeanPosition(scan);
  std::vector<std::pair<int, double>> known;
  for (const SurveyReading& reading : scan.readings) {
    const int field = map.FindField(reading.transmitter);
    if (field >= 0) known.emplace_back(field, reading.rssi_dbm);
  }
  cost.readings = known.size();
  for (std::size_t i = 0; i < kShifts.size(); ++i) {
    const FieldBasis basis = EvaluateBasis(map.grid, center + kShifts.At(i));
    double hearing = map.Silence(basis).value;
    double signal = 0, slope = 0, information = 0;
    for (const auto& [field, rssi_dbm] : known) {
      const FieldValue value = map.EvaluateValue(field, basis);
      const double inverse = std::exp(-value.log_sigma);
      const double z = (rssi_dbm - value.mean_dbm) * inverse;
      signal += 0.5 * z * z + value.log_sigma;
      slope += z * inverse;
      information += inverse * inverse;
      // -log p_hear + log(1 - p_hear) = -logit: the silence field counts everyone as missed.
      hearing -= value.logit_hear;
    }
    cost.signal_nats.push_back(signal - OffsetGain(slope, information, settings));
    cost.hearing_nats.push_back(hearing);
  }
  return cost;
}

// One held-out piece of a walk: the costs of its scans.
using Piece = std::vector<ScanCost>;

void AppendPieces(const RadioMap& map, const ScanList& walk, const TrainerSettings& settings,
                  std::vector<Piece>* pieces) {
  TimeNs piece_begin = 0;
  bool open = false;
  for (const SurveyScan* scan : walk) {
    ScanCost cost = CostOverShifts(map, *scan, settings);
    if (cost.readings == 0) continue;
    if (!open || SecondsBetween(piece_begin, cost.time_ns) > kPieceSeconds) {
      pieces->emplace_back();
      piece_begin = cost.time_ns;
      open = true;
    }
    pieces->back().push_back(std::move(cost));
  }
}

double PieceScore(const Piece& piece, const MapCalibration& trial,
                  const SharedErrorKernel& kernel) {
  std::vector<double> sum(kShifts.size(), 0.0);
  std::vector<double> alone(kShifts.size());
  double alone_score = 0;
  for (const ScanCost& scan : piece) {
    const double weight = std::min(1.0, trial.n_eff / static_cast<double>(scan.readings));
    for (std::size_t i = 0; i < sum.size(); ++i) {
      alone[i] = weight * (scan.signal_nats[i] + trial.hear_weight * scan.hearing_nats[i]);
      sum[i] += alone[i];
    }
    alone_score += kernel.LogScoreAtTruth(alone);
  }
  return kernel.LogScoreAtTruth(sum) + alone_score / static_cast<double>(piece.size());
}

struct Scored {
  MapCalibration calibration;
  double score = -std::numeric_limits<double>::infinity();
};

Scored BestCalibration(const std::vector<Piece>& pieces, std::span<const double> n_effs,
                       std::span<const double> hear_weights, std::span<const double> map_errors) {
  Scored best;
  for (const double sigma_m : map_errors) {
    const SharedErrorKernel kernel(kShifts, sigma_m);
    for (const double n_eff : n_effs) {
      for (const double hear_weight : hear_weights) {
        const MapCalibration trial{n_eff, hear_weight, sigma_m};
        double score = 0;
        for (const Piece& piece : pieces) score += PieceScore(piece, trial, kernel);
        if (score > best.score) best = {trial, score};
      }
    }
  }
  return best;
}

// The scans of a floor by trial and walk, and the maps that leave one third of the trials out.
class HeldOut {
 public:
  HeldOut(int floor, Radio radio, const FieldGrid& grid, const ScanList& scans,
          const TrainerSettings& settings, std::size_t max_transmitters)
      : floor_(floor), radio_(radio), grid_(grid), settings_(settings) {
    std::set<std::uint32_t> transmitters, walks;
    for (const SurveyScan* scan : scans) {
      by_trial_[scan->trial][scan->walk].push_back(scan);
      walks.insert(scan->walk);
      for (const SurveyReading& reading : scan->readings) transmitters.insert(reading.transmitter);
    }
    enough_ = walks.size() >= kMinWalks && by_trial_.size() >= kFolds;
    keep_every_ = (transmitters.size() + max_transmitters - 1) / max_transmitters;
  }

  bool enough() const { return enough_; }

  void AppendFold(std::size_t fold, const FieldModel& model, std::size_t max_walks,
                  std::vector<Piece>* pieces) const {
    ScanList training;
    std::vector<const ScanList*> held_out;
    std::size_t index = 0;
    for (const auto& [trial, walks] : by_trial_) {
      const bool out = index++ % kFolds == fold;
      for (const auto& [walk, list] : walks) {
        if (out) held_out.push_back(&list);
        if (!out) training.insert(training.end(), list.begin(), list.end());
      }
    }
    const RadioMap map =
        BuildMap(floor_, radio_, grid_, training, model, settings_, {keep_every_, kSearchSamples});
    const std::size_t count = std::min(max_walks, held_out.size());
    for (std::size_t i = 0; i < count; ++i) {
      AppendPieces(map, *held_out[i * held_out.size() / count], settings_, pieces);
    }
  }

 private:
  int floor_;
  Radio radio_;
  const FieldGrid& grid_;
  const TrainerSettings& settings_;
  std::map<std::uint32_t, std::map<std::uint32_t, ScanList>> by_trial_;
  bool enough_ = false;
  std::size_t keep_every_ = 1;
};

double ModelScore(const HeldOut& held_out, const FieldModel& model,
                  std::size_t max_walks = kWalksPerFold) {
  std::vector<Piece> pieces;
  held_out.AppendFold(0, model, max_walks, &pieces);
  const std::array hear_weights{MapCalibration().hear_weight};
  return BestCalibration(pieces, kCoarseNEff, hear_weights, kCoarseMapErrors).score;
}

// Moves one parameter along its ladder, from the value it has, as long as the score grows.
void Climb(const HeldOut& held_out, std::span<const double> ladder,
           const std::function<double&(FieldModel&)>& parameter, FieldModel* model, double* score) {
  const auto start = std::find(ladder.begin(), ladder.end(), parameter(*model));
  for (const std::ptrdiff_t direction : {-1, 1}) {
    bool moved = false;
    for (auto at = start - ladder.begin() + direction; at >= 0 && at < std::ssize(ladder);
         at += direction) {
      FieldModel trial = *model;
      parameter(trial) = ladder[static_cast<std::size_t>(at)];
      const double trial_score = ModelScore(held_out, trial);
      if (!(trial_score > *score)) break;
      *score = trial_score;
      *model = trial;
      moved = true;
    }
    if (moved) return;
  }
}

}  // namespace

std::optional<double> PlacementScore(int floor, Radio radio, const FieldGrid& grid,
                                     const ScanList& scans, const TrainerSettings& settings) {
  const HeldOut held_out(floor, radio, grid, scans, settings, kSearchTransmitters);
  if (!held_out.enough()) return std::nullopt;
  return ModelScore(held_out, FieldModel(), kAllWalks);
}

FieldModel SelectFieldModel(int floor, Radio radio, const FieldGrid& grid, const ScanList& scans,
                            const TrainerSettings& settings) {
  constexpr std::array kLengths{5.0, 7.0, 10.0, 14.0, 20.0, 28.0};
  constexpr std::array kBandwidths{1.2, 1.7, 2.5, 3.5, 5.0, 7.0};
  constexpr std::array kNoises{2.0, 3.0, 4.0, 5.0, 6.0};
  FieldModel model;
  const HeldOut held_out(floor, radio, grid, scans, settings, kSearchTransmitters);
  if (held_out.enough()) {
    double score = ModelScore(held_out, model);
    Climb(
        held_out, kLengths, [](FieldModel& m) -> double& { return m.prior.length_m; }, &model,
        &score);
    Climb(
        held_out, kBandwidths, [](FieldModel& m) -> double& { return m.hear_bandwidth_m; }, &model,
        &score);
    Climb(
        held_out, kNoises, [](FieldModel& m) -> double& { return m.prior.noise_db; }, &model,
        &score);
  }
  model.sigma_scale = LeftOutSigmaScale(CollectSamples(scans, settings), model.prior);
  return model;
}

MapCalibration CalibrateMap(int floor, Radio radio, const FieldGrid& grid, const ScanList& scans,
                            const FieldModel& model, const TrainerSettings& settings) {
  const HeldOut held_out(floor, radio, grid, scans, settings, kCalibrationTransmitters);
  if (!held_out.enough()) return {};
  std::vector<Piece> pieces;
  for (std::size_t fold = 0; fold < kFolds; ++fold)
    held_out.AppendFold(fold, model, kWalksPerFold, &pieces);
  const Scored coarse = BestCalibration(pieces, kCoarseNEff, kHearWeights, kCoarseMapErrors);
  const std::array hear_weights{coarse.calibration.hear_weight};
  return BestCalibration(pieces, kNEff, hear_weights, kMapErrors).calibration;
}

}  // namespace walkgraph
