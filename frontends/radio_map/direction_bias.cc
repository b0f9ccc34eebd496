#include "frontends/radio_map/direction_bias.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "data/angle.h"
#include "frontends/radio_map/body_shadow.h"
#include "frontends/radio_map/held_out_pieces.h"

namespace walkgraph {
namespace {

constexpr double kLeastLagS = -0.75, kMostLagS = 2.25;
const Eigen::Vector2d kPriorSigma(1.0, 3.0);  // s, dB
constexpr double kHalfWayS = 0.5;             // a velocity is taken over twice this

// (lag, shadow) in s and dB.
using Biases = Eigen::Vector2d;

struct Row {
  double weight = 0;                   // 1/dB^2
  Biases regressors = Biases::Zero();  // dB per s of lag, and per dB of shadow
  double residual_db = 0;              // what was read beyond the map
};

// Weighted least squares of residuals on both regressors, of which some may be left out.
class Regression {
 public:
  explicit Regression(const Eigen::Array2d& takes_part) : takes_part_(takes_part) {}

  // The rows of a scan, to all of which its phone may add the same.
  void AddScan(std::uint32_t trial, const std::vector<Row>& rows) {
    double weight = 0, residual = 0;
    Biases regressors = Biases::Zero();
    for (const Row& row : rows) {
      weight += row.weight;
      residual += row.weight * row.residual_db;
      regressors += row.weight * row.regressors;
    }
    Equations& of_trial = by_trial_[trial];
    for (const Row& row : rows) {
      const Biases x = takes_part_ * (row.regressors - regressors / weight).array();
      of_trial.normal += row.weight * x * x.transpose();
      of_trial.right += row.weight * (row.residual_db - residual / weight) * x;
    }
  }

  struct Fit {
    Biases value;
    Eigen::Matrix2d covariance;  // by the scatter over trials (sandwich estimator)
  };
  Fit Solve() const {
    Equations all;
    for (const auto& [trial, equations] : by_trial_) {
      all.normal += equations.normal;
      all.right += equations.right;
    }
    // A trace of what nobody's walk tells, so that it comes out as zero.
    all.normal += 1e-6 * Eigen::Matrix2d::Identity();
    const Eigen::Matrix2d inverse = all.normal.inverse();
    const Biases value = inverse * all.right;
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (const auto& [trial, equations] : by_trial_) {
      const Biases score = equations.right - equations.normal * value;
      scatter += score * score.transpose();
    }
    return {value, inverse * scatter * inverse};
  }

 private:
  struct Equations {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Biases right = Biases::Zero();
  };
  Eigen::Array2d takes_part_;
  std::map<std::uint32_t, Equations> by_trial_;
};

// A survey's scans as they are stamped, and a little earlier and later, which tells how fast the
// walker went.
class StampedSurvey {
 public:
  explicit StampedSurvey(const RadioSurvey& survey)
      : now_(survey.Scans(0, kRange)),
        before_(survey.Scans(-kHalfWayS, kRange)),
        after_(survey.Scans(kHalfWayS, kRange)) {}

  // Of all floors, as they are stamped.
  const std::vector<SurveyScan>& scans() const { return now_; }

  std::vector<Row> RowsOf(const RadioMap& map, const SurveyScan& scan) const {
    const auto index = static_cast<std::size_t>(&scan - now_.data());
    std::vector<Row> rows;
    for (std::size_t i = 0; i < scan.readings.size(); ++i) {
      const SurveyReading& reading = scan.readings[i];
      const int field = map.FindField(reading.transmitter);
      if (field < 0) continue;
      const Eigen::Vector2d at = reading.position_m.cast<double>();
      const Eigen::Vector2d velocity_mps =
          (after_[index].readings[i].position_m - before_[index].readings[i].position_m)
              .cast<double>() /
          (2 * kHalfWayS);
      const Eigen::Vector2d ahead = DirectionOf(double{reading.heading_rad});
      const FieldValue value = map.Evaluate(field, EvaluateBasis(map.grid, at));
      const auto source = map.fields[static_cast<std::size_t>(field)].source_m.cast<double>();
      const BodyShadow unit = ShadowOf(1.0, BearingOf(source, at), ahead);
      rows.push_back({std::exp(-2 * value.log_sigma),
                      {velocity_mps.dot(value.d_mean), unit.value_db},
                      reading.rssi_dbm - value.mean_dbm});
    }
    return rows;
  }

 private:
  // Of the same readings all three times.
  static constexpr LagRange kRange{-kHalfWayS, kHalfWayS};
  std::vector<SurveyScan> now_, before_, after_;
};

// Nothing where no floor has enough walks.
std::optional<Regression::Fit> FitBiases(const RadioSurvey& survey, const Executor& run) {
  const TrainerSettings& settings = survey.settings;
  Regression regression({settings.calibrate_lag ? 1.0 : 0.0, settings.shade_readings ? 1.0 : 0.0});
  bool any = false;
  const StampedSurvey stamped(survey);
  for (const int number : FloorsOf(stamped.scans())) {
    const FloorSurvey floor = survey.OfFloor(stamped.scans(), number);
    HeldOutTrials trials(floor, settings, kSearchTransmitters, run);
    if (!trials.enough()) continue;
    any = true;
    for (std::size_t fold = 0; fold < kCalibrationFolds; ++fold) {
      const RadioMap map = trials.MapWithout(fold, FieldModel());
      for (const ScanList* walk : trials.HeldOut(fold)) {
        for (const SurveyScan* scan : *walk) {
          regression.AddScan(scan->trial, stamped.RowsOf(map, *scan));
        }
      }
    }
  }
  return any ? std::optional(regression.Solve()) : std::nullopt;
}

}  // namespace

DirectionBias CalibrateDirectionBias(const RadioSurvey& survey, const Executor& run) {
  const auto fit = FitBiases(survey, run);
  if (!fit) return {};
  const Eigen::Matrix2d prior = kPriorSigma.array().square().matrix().asDiagonal();
  const Biases bias = prior * (prior + fit->covariance).inverse() * fit->value;
  return {std::clamp(bias[0], kLeastLagS, kMostLagS), std::max(bias[1], 0.0)};
}

}  // namespace walkgraph
