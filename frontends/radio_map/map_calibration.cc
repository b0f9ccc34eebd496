#include "frontends/radio_map/map_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace walkgraph {
namespace {

constexpr int kFolds = 3;
constexpr std::size_t kMinWalks = 6;
constexpr std::size_t kWalksPerFold = 12;
constexpr double kPieceSeconds = 20;
constexpr double kShiftSpacingM = 2;
constexpr int kShiftHalfCount = 12;
constexpr int kShiftCount = (2 * kShiftHalfCount + 1) * (2 * kShiftHalfCount + 1);
// Chance that a piece lies where nothing is known: keeps one lost walk from deciding the score.
constexpr double kLostProbability = 0.02;

constexpr std::array kNEff{0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 9.0, 13.0, 20.0};
constexpr std::array kMapErrors{0.7, 1.0, 1.4, 2.0, 2.8, 4.0, 5.6, 8.0};

Eigen::Vector2d Shift(int index) {
  const int side = 2 * kShiftHalfCount + 1;
  return kShiftSpacingM *
         Eigen::Vector2d(index % side - kShiftHalfCount, index / side - kShiftHalfCount);
}

// -log p of a scan, moved by every shift.
struct ScanCost {
  TimeNs time_ns = 0;
  std::size_t readings = 0;
  std::vector<double> nats;
};

ScanCost CostOverShifts(const RadioMap& map, const SurveyScan& scan) {
  ScanCost cost;
  cost.time_ns = scan.printed_ns;
  cost.nats.assign(kShiftCount, 0.0);
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  for (const SurveyReading& reading : scan.readings) {
    center += reading.position_m.cast<double>();
    const int field = map.FindField(reading.transmitter);
    if (field < 0) continue;
    ++cost.readings;
    for (int i = 0; i < kShiftCount; ++i) {
      const Eigen::Vector2d at = reading.position_m.cast<double>() + Shift(i);
      const FieldValue value = map.Evaluate(field, EvaluateBasis(map.grid, at));
      const double z = (reading.rssi_dbm - value.mean_dbm) * std::exp(-value.log_sigma);
      // -log p_hear + log(1 - p_hear) = -logit: the silence field counts everyone as missed.
      cost.nats[static_cast<std::size_t>(i)] += 0.5 * z * z + value.log_sigma - value.logit_hear;
    }
  }
  center /= static_cast<double>(scan.readings.size());
  for (int i = 0; i < kShiftCount; ++i) {
    cost.nats[static_cast<std::size_t>(i)] +=
        map.Silence(EvaluateBasis(map.grid, center + Shift(i)), nullptr);
  }
  return cost;
}

// One held-out piece of a walk: the costs of its scans.
using Piece = std::vector<ScanCost>;

void AppendPieces(const RadioMap& map, const ScanList& walk, std::vector<Piece>* pieces) {
  TimeNs piece_begin = 0;
  bool open = false;
  for (const SurveyScan* scan : walk) {
    ScanCost cost = CostOverShifts(map, *scan);
    if (cost.readings == 0) continue;
    if (!open || SecondsBetween(piece_begin, cost.time_ns) > kPieceSeconds) {
      pieces->emplace_back();
      piece_begin = cost.time_ns;
      open = true;
    }
    pieces->back().push_back(std::move(cost));
  }
}

// log of the density (1/m^2) that the posterior proportional to exp(-nats), blurred by the map
// error, gives to shift zero.
double LogScoreAtTruth(const std::vector<double>& nats, double map_error_sigma_m) {
  const double lowest = *std::min_element(nats.begin(), nats.end());
  double total = 0, blurred = 0;
  const double variance = map_error_sigma_m * map_error_sigma_m;
  // The kernel is normalised over the grid, so that a sigma below its spacing stays a density.
  double kernel_total = 0;
  for (int i = 0; i < kShiftCount; ++i) {
    const double p = std::exp(lowest - nats[static_cast<std::size_t>(i)]);
    const double kernel = std::exp(-0.5 * Shift(i).squaredNorm() / variance);
    total += p;
    kernel_total += kernel;
    blurred += p * kernel;
  }
  const double cell = kShiftSpacingM * kShiftSpacingM;
  const double density = blurred / (total * kernel_total * cell);
  return std::log((1.0 - kLostProbability) * density + kLostProbability / (kShiftCount * cell));
}

double PieceScore(const Piece& piece, double n_eff, double map_error_sigma_m) {
  std::vector<double> sum(kShiftCount, 0.0);
  std::vector<double> alone(kShiftCount);
  double alone_score = 0;
  for (const ScanCost& scan : piece) {
    const double weight = std::min(1.0, n_eff / static_cast<double>(scan.readings));
    for (std::size_t i = 0; i < sum.size(); ++i) {
      alone[i] = weight * scan.nats[i];
      sum[i] += alone[i];
    }
    alone_score += LogScoreAtTruth(alone, map_error_sigma_m);
  }
  return LogScoreAtTruth(sum, map_error_sigma_m) + alone_score / static_cast<double>(piece.size());
}

MapCalibration BestCalibration(const std::vector<Piece>& pieces) {
  MapCalibration best;
  double best_score = -1e300;
  for (const double n_eff : kNEff) {
    for (const double sigma_m : kMapErrors) {
      double score = 0;
      for (const Piece& piece : pieces) score += PieceScore(piece, n_eff, sigma_m);
      if (score > best_score) {
        best_score = score;
        best = {n_eff, sigma_m};
      }
    }
  }
  return best;
}

}  // namespace

MapCalibration CalibrateMap(int floor, Radio radio, const FieldGrid& grid, const ScanList& scans,
                            const FieldModel& model, const TrainerSettings& settings) {
  std::map<std::uint32_t, ScanList> by_walk;
  for (const SurveyScan* scan : scans) by_walk[scan->walk].push_back(scan);
  if (by_walk.size() < kMinWalks) return {};
  std::vector<Piece> pieces;
  for (int fold = 0; fold < kFolds; ++fold) {
    ScanList training;
    std::vector<const ScanList*> held_out;
    int index = 0;
    for (const auto& [walk, list] : by_walk) {
      if (index++ % kFolds == fold) {
        held_out.push_back(&list);
      } else {
        training.insert(training.end(), list.begin(), list.end());
      }
    }
    const RadioMap map = BuildMap(floor, radio, grid, training, model, settings);
    const std::size_t count = std::min(kWalksPerFold, held_out.size());
    for (std::size_t i = 0; i < count; ++i) {
      AppendPieces(map, *held_out[i * held_out.size() / count], &pieces);
    }
  }
  return pieces.empty() ? MapCalibration{} : BestCalibration(pieces);
}

}  // namespace walkgraph
