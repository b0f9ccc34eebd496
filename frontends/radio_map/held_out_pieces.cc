#include "frontends/radio_map/held_out_pieces.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "frontends/radio_map/survey_scans.h"

namespace walkgraph {
namespace {

constexpr std::size_t kMinWalks = 6;
constexpr std::size_t kSearchSamples = 120;
constexpr double kPieceSeconds = 20;

// What the best common offset of a scan's readings takes off its cost: the phone held against the
// body hears everything weaker. Normal prior, integrated out.
double OffsetGain(double slope, double information, const TrainerSettings& settings) {
  const double variance = settings.rssi_offset_sigma_db * settings.rssi_offset_sigma_db;
  const double spread = 1.0 + variance * information;
  return 0.5 * variance * slope * slope / spread - 0.5 * std::log(spread);
}

ScanCost CostOverShifts(const RadioMap& map, const SurveyScan& scan, const ShiftGrid& shifts,
                        const TrainerSettings& settings) {
  // The spread of a scan's readings along the walk matters less than the grid of shifts.
  const Eigen::Vector2d center = MeanPosition(scan);
  std::vector<std::pair<int, double>> known;
  for (const SurveyReading& reading : scan.readings) {
    const int field = map.FindField(reading.transmitter);
    if (field >= 0) known.emplace_back(field, double{reading.rssi_dbm} - reading.shadow_db);
  }
  const auto count = static_cast<Eigen::Index>(shifts.size());
  ScanCost cost{known.size(), Eigen::ArrayXd(count), Eigen::ArrayXd(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const FieldBasis basis =
        EvaluateBasis(map.grid, center + shifts.At(static_cast<std::size_t>(i)));
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
    cost.signal_nats[i] = signal - OffsetGain(slope, information, settings);
    cost.hearing_nats[i] = hearing;
  }
  return cost;
}

double SurveyDistanceOf(const RadioMap& map, const SurveyScan& scan) {
  return map.SurveyDistance(EvaluateBasis(map.grid, MeanPosition(scan))).value;
}

void AppendPieces(const RadioMap& map, const ScanList& walk, const ShiftGrid& shifts,
                  const TrainerSettings& settings, std::vector<HeldOutPiece>* pieces) {
  TimeNs piece_begin = 0;
  bool open = false;
  for (const SurveyScan* scan : walk) {
    ScanCost cost = CostOverShifts(map, *scan, shifts, settings);
    if (cost.readings == 0) continue;
    if (!open || SecondsBetween(piece_begin, scan->printed_ns) > kPieceSeconds) {
      pieces->emplace_back();
      piece_begin = scan->printed_ns;
      open = true;
    }
    HeldOutPiece& piece = pieces->back();
    const auto before = static_cast<double>(piece.scans.size());
    piece.survey_distance_m =
        (before * piece.survey_distance_m + SurveyDistanceOf(map, *scan)) / (before + 1);
    piece.scans.push_back(std::move(cost));
  }
}

}  // namespace

const ShiftGrid& WideShifts() {
  static const ShiftGrid shifts(2.5, 8);
  return shifts;
}

const ShiftGrid& FineShifts() {
  static const ShiftGrid shifts(2.5, 8, 1, 5);
  return shifts;
}

HeldOutTrials::HeldOutTrials(const FloorSurvey& survey, const TrainerSettings& settings,
                             std::size_t max_transmitters, const Executor& run)
    : survey_(survey), settings_(settings), run_(run) {
  std::set<std::uint32_t> transmitters, walks;
  for (const SurveyScan* scan : survey.scans) {
    by_trial_[scan->trial][scan->walk].push_back(scan);
    walks.insert(scan->walk);
    for (const SurveyReading& reading : scan->readings) transmitters.insert(reading.transmitter);
  }
  enough_ = walks.size() >= kMinWalks && by_trial_.size() >= kCalibrationFolds;
  keep_every_ = (transmitters.size() + max_transmitters - 1) / max_transmitters;
}

HeldOutTrials::Fold HeldOutTrials::MakeFold(std::size_t fold) const {
  FloorSurvey training{survey_.floor, survey_.radio, survey_.grid, {}};
  Fold result;
  std::size_t index = 0;
  for (const auto& [trial, walks] : by_trial_) {
    const bool out = index++ % kCalibrationFolds == fold;
    for (const auto& [walk, list] : walks) {
      if (out) result.held_out.push_back(&list);
      if (!out) training.scans.insert(training.scans.end(), list.begin(), list.end());
    }
  }
  result.input = MakeMapInput(
      training, settings_, {.keep_every = keep_every_, .max_samples = kSearchSamples, .fits = {}});
  return result;
}

const HeldOutTrials::Fold& HeldOutTrials::FoldAt(std::size_t fold) {
  if (!folds_.contains(fold)) folds_[fold] = MakeFold(fold);
  return folds_[fold];
}

RadioMap HeldOutTrials::MapWithout(std::size_t fold, const FieldModel& model) {
  return BuildMap(FoldAt(fold).input, model, settings_, run_);
}

void HeldOutTrials::AppendFold(std::size_t fold, const FieldModel& model, const ShiftGrid& shifts,
                               std::size_t max_walks, std::vector<HeldOutPiece>* pieces) {
  const RadioMap map = MapWithout(fold, model);
  const std::vector<const ScanList*>& held_out = HeldOut(fold);
  const std::size_t count = std::min(max_walks, held_out.size());
  std::vector<std::vector<HeldOutPiece>> of_walk(count);
  run_(count, [&](std::size_t i) {
    AppendPieces(map, *held_out[i * held_out.size() / count], shifts, settings_, &of_walk[i]);
  });
  for (std::vector<HeldOutPiece>& more : of_walk) {
    std::move(more.begin(), more.end(), std::back_inserter(*pieces));
  }
}

}  // namespace walkgraph
