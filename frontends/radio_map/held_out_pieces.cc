#include "frontends/radio_map/held_out_pieces.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "frontends/radio_map/field_lattice.h"
#include "frontends/radio_map/survey_scans.h"

namespace walkgraph {
namespace {

constexpr std::size_t kMinWalks = 6;
constexpr std::size_t kSearchSamples = 120;
constexpr double kPieceSeconds = 20;

// -log p of a scan at all places of a lattice.
struct LatticeCost {
  Eigen::ArrayXd signal_nats, hearing_nats;
};

// A reading of a transmitter that the map knows.
struct KnownReading {
  std::size_t field = 0;
  float rssi_dbm = 0;  // without the body's shadow
};

ControlValues ControlsOf(const RadioMap::TransmitterField& field, const std::vector<float>& values,
                         float background) {
  return {field.column, field.row, field.columns, field.rows, values, background};
}

LatticeCost CostOnLattice(const RadioMap& map, const std::vector<KnownReading>& readings,
                          const FieldLattice& lattice, const TrainerSettings& settings) {
  const ControlValues silence{0, 0, map.grid.columns, map.grid.rows, map.silence_nats, 0};
  LatticeCost cost;
  cost.hearing_nats = lattice.Evaluate(silence).cast<double>();
  cost.signal_nats.setZero(cost.hearing_nats.size());
  Eigen::ArrayXd slope = cost.signal_nats, information = cost.signal_nats;
  for (const KnownReading& reading : readings) {
    const RadioMap::TransmitterField& field = map.fields[reading.field];
    const Eigen::ArrayXf log_sigma =
        lattice.Evaluate(ControlsOf(field, field.log_sigma, field.background_log_sigma));
    const Eigen::ArrayXf inverse = (-log_sigma).exp();
    const Eigen::ArrayXf z =
        inverse * (reading.rssi_dbm -
                   lattice.Evaluate(ControlsOf(field, field.mean_dbm, field.background_mean_dbm)));
    cost.signal_nats += (0.5F * z.square() + log_sigma).cast<double>();
    slope += (z * inverse).cast<double>();
    information += inverse.square().cast<double>();
    // -log p_hear + log(1 - p_hear) = -logit: the silence field counts everyone as missed.
    cost.hearing_nats -=
        lattice.Evaluate(ControlsOf(field, field.logit_hear, field.background_logit_hear))
            .cast<double>();
  }
  // What the best common offset of a scan's readings takes off its cost: the phone held against the
  // body hears everything weaker. Normal prior, integrated out.
  const double variance = settings.rssi_offset_sigma_db * settings.rssi_offset_sigma_db;
  const Eigen::ArrayXd spread = 1.0 + variance * information;
  cost.signal_nats -= 0.5 * variance * slope.square() / spread - 0.5 * spread.log();
  return cost;
}

ScanCost CostOverShifts(const RadioMap& map, const SurveyScan& scan, const ShiftGrid& shifts,
                        const TrainerSettings& settings) {
  std::vector<KnownReading> known;
  for (const SurveyReading& reading : scan.readings) {
    const int field = map.FindField(reading.transmitter);
    if (field < 0) continue;
    known.push_back({static_cast<std::size_t>(field), reading.rssi_dbm - reading.shadow_db});
  }
  // The spread of a scan's readings along the walk matters less than the grid of shifts.
  const Eigen::Vector2d center = MeanPosition(scan);
  std::vector<Eigen::ArrayXd> signal_nats, hearing_nats;
  for (const ShiftGrid::Lattice& lattice : shifts.lattices()) {
    const Eigen::Vector2d first = center.array() - lattice.half_count * lattice.spacing_m;
    LatticeCost cost =
        CostOnLattice(map, known, {map.grid, first, lattice.spacing_m, lattice.side()}, settings);
    signal_nats.push_back(std::move(cost.signal_nats));
    hearing_nats.push_back(std::move(cost.hearing_nats));
  }
  return {known.size(), shifts.Join(signal_nats), shifts.Join(hearing_nats)};
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
  const std::size_t step = (transmitters.size() + max_transmitters - 1) / max_transmitters;
  std::size_t index = 0;
  for (const std::uint32_t transmitter : transmitters) {
    selection_.selected.resize(transmitter + 1);
    selection_.selected.back() = index++ % step == 0;
  }
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
      training, settings_, {.transmitters = selection_, .max_samples = kSearchSamples, .fits = {}});
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
