#include "frontends/radio_map/map_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

#include "frontends/radio_map/held_out_pieces.h"
#include "frontends/radio_map/shift_posterior.h"

namespace walkgraph {
namespace {

constexpr std::size_t kWalksPerFold = 16;
// Calibration sees more transmitters than the searches.
constexpr std::size_t kCalibrationTransmitters = 400;

// A coarse grid compares field models and hearing weights, the fine one sets the numbers.
constexpr std::array kCoarseNEff{1.0, 3.0, 9.0};
constexpr std::array kCoarseMapErrors{1.4, 2.8};
constexpr std::array kNoGrowth{0.0};
constexpr std::array kNEff{0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 9.0, 13.0, 20.0};
constexpr std::array kHearWeights{0.2, 0.4, 0.7, 1.0};
constexpr std::array kMapErrors{0.35, 0.5, 0.7, 1.0, 1.4, 2.0, 2.8, 4.0, 5.6, 8.0};
constexpr std::array kGrowths{0.125, 0.25, 0.35, 0.5, 0.7, 1.0, 1.4};

// Pieces of held-out walks with the shifts they were moved by.
struct MovedPieces {
  const ShiftGrid& shifts;
  const Executor& run;
  std::vector<HeldOutPiece> pieces;
};

PiecePosterior PosteriorOf(const ShiftGrid& shifts, const HeldOutPiece& piece, double n_eff,
                           double hear_weight) {
  std::vector<Eigen::ArrayXd> nats;
  for (const ScanCost& scan : piece.scans) {
    const double weight = std::min(1.0, n_eff / static_cast<double>(scan.readings));
    nats.push_back(weight * (scan.signal_nats + hear_weight * scan.hearing_nats));
  }
  return PiecePosterior(shifts, nats);
}

// What is known of a calibrated number before a survey is seen: its default, within a factor of
// two.
double LogPriorAbout(double known, double value) {
  const double octaves = std::log2(value / known);
  return -0.5 * octaves * octaves;
}

// A growth of zero is not asked for.
double LogPrior(const MapCalibration& calibration) {
  const MapCalibration known;
  const double growth = calibration.map_error_growth;
  return LogPriorAbout(known.n_eff, calibration.n_eff) +
         LogPriorAbout(known.map_error_sigma_m, calibration.map_error_sigma_m) +
         (growth > 0 ? LogPriorAbout(known.map_error_growth, growth) : 0.0);
}

struct Scored {
  MapCalibration calibration;
  double score = -std::numeric_limits<double>::infinity();  // log likelihood of the pieces
};

struct CalibrationGrid {
  std::span<const double> n_effs, hear_weights, map_errors, growths;
};

// All map errors for posteriors that the n_eff and hear_weight of `trial` have made.
void ScoreMapErrors(const std::vector<HeldOutPiece>& pieces,
                    const std::vector<PiecePosterior>& posteriors, MapCalibration trial,
                    const CalibrationGrid& grid, SharedErrorKernels* kernels,
                    std::vector<Scored>* scored) {
  for (const double sigma_m : grid.map_errors) {
    for (const double growth : grid.growths) {
      trial.map_error_sigma_m = sigma_m;
      trial.map_error_growth = growth;
      double score = 0;
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double grown_m = growth * std::round(pieces[i].survey_distance_m);
        score += posteriors[i].Score(kernels->At(std::hypot(sigma_m, grown_m)));
      }
      scored->push_back({trial, score});
    }
  }
}

std::vector<Scored> ScoreCalibrations(const MovedPieces& moved, const CalibrationGrid& grid) {
  std::vector<Scored> scored;
  SharedErrorKernels kernels(moved.shifts);
  for (const double n_eff : grid.n_effs) {
    for (const double hear_weight : grid.hear_weights) {
      std::vector<PiecePosterior> posteriors(moved.pieces.size());
      moved.run(posteriors.size(), [&](std::size_t i) {
        posteriors[i] = PosteriorOf(moved.shifts, moved.pieces[i], n_eff, hear_weight);
      });
      ScoreMapErrors(moved.pieces, posteriors, {.n_eff = n_eff, .hear_weight = hear_weight}, grid,
                     &kernels, &scored);
    }
  }
  return scored;
}

// The likeliest.
Scored BestCalibration(const MovedPieces& pieces, const CalibrationGrid& grid) {
  Scored best;
  for (const Scored& trial : ScoreCalibrations(pieces, grid)) {
    if (trial.score > best.score) best = trial;
  }
  return best;
}

// Posterior means: a survey of few pieces, for which half of the grid is as likely as the best,
// gives no number of its own to each handful of walks. Of the map error the variance, which is what
// an error of unknown sigma has; of the others the logarithm.
MapCalibration MeanCalibration(const MovedPieces& pieces, const CalibrationGrid& grid) {
  std::vector<Scored> scored = ScoreCalibrations(pieces, grid);
  double most = -std::numeric_limits<double>::infinity();
  for (Scored& trial : scored) {
    trial.score += LogPrior(trial.calibration);
    most = std::max(most, trial.score);
  }
  double total = 0, log_n_eff = 0, log_hear = 0, variance_m2 = 0, growth = 0;
  for (const Scored& trial : scored) {
    const double weight = std::exp(trial.score - most);
    total += weight;
    log_n_eff += weight * std::log(trial.calibration.n_eff);
    log_hear += weight * std::log(trial.calibration.hear_weight);
    variance_m2 += weight * std::pow(trial.calibration.map_error_sigma_m, 2);
    growth += weight * trial.calibration.map_error_growth;
  }
  return {std::exp(log_n_eff / total), std::exp(log_hear / total), std::sqrt(variance_m2 / total),
          growth / total};
}

double ModelScore(const FieldModel& model, HeldOutTrials* held_out) {
  MovedPieces pieces{WideShifts(), held_out->run(), {}};
  held_out->AppendFold(0, model, pieces.shifts, kWalksPerFold, &pieces.pieces);
  const std::array hear_weights{MapCalibration().hear_weight};
  return BestCalibration(pieces, {kCoarseNEff, hear_weights, kCoarseMapErrors, kNoGrowth}).score;
}

// Moves one parameter along its ladder, from the value it has, as long as the score grows.
void Climb(std::span<const double> ladder, const std::function<double&(FieldModel&)>& parameter,
           HeldOutTrials* held_out, FieldModel* model, double* score) {
  const auto start = std::find(ladder.begin(), ladder.end(), parameter(*model));
  for (const std::ptrdiff_t direction : {-1, 1}) {
    bool moved = false;
    for (auto at = start - ladder.begin() + direction; at >= 0 && at < std::ssize(ladder);
         at += direction) {
      FieldModel trial = *model;
      parameter(trial) = ladder[static_cast<std::size_t>(at)];
      const double trial_score = ModelScore(trial, held_out);
      if (!(trial_score > *score)) break;
      *score = trial_score;
      *model = trial;
      moved = true;
    }
    if (moved) return;
  }
}

}  // namespace

FieldModel SelectFieldModel(const FloorSurvey& survey, const TrainerSettings& settings,
                            const Executor& run) {
  constexpr std::array kLengths{5.0, 7.0, 10.0, 14.0, 20.0, 28.0};
  constexpr std::array kBandwidths{1.2, 1.7, 2.5, 3.5, 5.0, 7.0};
  constexpr std::array kNoises{2.0, 3.0, 4.0, 5.0, 6.0};
  FieldModel model;
  HeldOutTrials held_out(survey, settings, kSearchTransmitters, run);
  if (held_out.enough()) {
    double score = ModelScore(model, &held_out);
    Climb(
        kLengths, [](FieldModel& m) -> double& { return m.prior.length_m; }, &held_out, &model,
        &score);
    Climb(
        kBandwidths, [](FieldModel& m) -> double& { return m.hear_bandwidth_m; }, &held_out, &model,
        &score);
    Climb(
        kNoises, [](FieldModel& m) -> double& { return m.prior.noise_db; }, &held_out, &model,
        &score);
  }
  model.sigma_scale = LeftOutSigmaScale(survey.scans, settings, model.prior, run);
  return model;
}

MapCalibration CalibrateMap(const FloorSurvey& survey, const FieldModel& model,
                            const TrainerSettings& settings, const Executor& run) {
  HeldOutTrials held_out(survey, settings, kCalibrationTransmitters, run);
  if (!held_out.enough()) return {};
  MovedPieces pieces{FineShifts(), run, {}};
  for (std::size_t fold = 0; fold < kCalibrationFolds; ++fold) {
    held_out.AppendFold(fold, model, pieces.shifts, kWalksPerFold, &pieces.pieces);
  }
  const Scored coarse =
      BestCalibration(pieces, {kCoarseNEff, kHearWeights, kCoarseMapErrors, kNoGrowth});
  const std::array hear_weights{coarse.calibration.hear_weight};
  // The growth last, beside what an error that is the same everywhere asks for: chosen together, a
  // part of the error that no two scans share goes into it, and readings are trusted too far.
  const MapCalibration uniform =
      MeanCalibration(pieces, {kNEff, hear_weights, kMapErrors, kNoGrowth});
  const std::array n_effs{uniform.n_eff};
  const std::array map_errors{uniform.map_error_sigma_m};
  return MeanCalibration(pieces, {n_effs, hear_weights, map_errors, kGrowths});
}

}  // namespace walkgraph
