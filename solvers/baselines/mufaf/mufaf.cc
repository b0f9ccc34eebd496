#include "solvers/baselines/mufaf/mufaf.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "factors/dead_reckoning.h"
#include "solvers/baselines/fixes.h"
#include "solvers/baselines/mufaf/tracking.h"

namespace walkgraph {
namespace {

constexpr Eigen::Index kCellsForError = 300;

// What one radio said at one time.
struct RadioReport {
  TimeNs time_ns = 0;
  std::size_t radio = 0;  // index among those in use
  RadioFix fix;
};

std::vector<RadioReport> LocateRadio(const SiteCells& cells, const std::vector<QueryScan>& scans,
                                     std::size_t radio, const CellEstimatorSettings& estimator,
                                     double error_m) {
  std::vector<RadioReport> reports;
  for (const QueryScan& scan : scans) {
    const std::optional<Eigen::VectorXd> signals = cells.SignalsOf(scan.signal);
    if (!signals) continue;
    reports.push_back(
        {scan.time_ns, radio, {EstimatePosition(cells.map(), *signals, estimator), error_m}});
  }
  return reports;
}

// Reports within a window of its first, in order of time.
using Epoch = std::vector<RadioReport>;
std::vector<Epoch> GroupReports(std::vector<RadioReport> reports, double window_s) {
  std::stable_sort(reports.begin(), reports.end(), [](const RadioReport& a, const RadioReport& b) {
    return a.time_ns < b.time_ns;
  });
  std::vector<Epoch> epochs;
  for (const RadioReport& report : reports) {
    if (epochs.empty() ||
        SecondsBetween(epochs.back().front().time_ns, report.time_ns) >= window_s) {
      epochs.emplace_back();
    }
    epochs.back().push_back(report);
  }
  return epochs;
}

// The tracks through all epochs: one of all radios, or one each that are fused.
class Tracks {
 public:
  Tracks(const MufafSettings& settings, bool one_per_radio, std::size_t radios)
      : model_{settings.acceleration_sigma_mps2, settings.input_mps2},
        tracks_(one_per_radio ? radios : 1) {}

  // The state at the end of an epoch, `seconds` after the last one.
  KalmanState<4> Advance(const Epoch& epoch, double seconds) {
    std::vector<KalmanState<4>> known;
    for (std::size_t t = 0; t < tracks_.size(); ++t) {
      std::optional<KalmanState<4>>& track = tracks_[t];
      std::vector<RadioFix> fixes;
      for (const RadioReport& report : epoch) {
        if (tracks_.size() == 1 || report.radio == t) fixes.push_back(report.fix);
      }
      if (track) {
        track = model_.Predict(*track, seconds);
        if (!fixes.empty()) track = UpdateTrack(*track, fixes);
      } else if (!fixes.empty()) {
        track = BeginTrack(fixes.front());
        if (fixes.size() > 1) track = UpdateTrack(*track, {fixes.begin() + 1, fixes.end()});
      }
      if (track) known.push_back(*track);
    }
    return known.size() == 1 ? known.front() : FuseTracks<4>(known);
  }

 private:
  ConstantVelocity model_;
  std::vector<std::optional<KalmanState<4>>> tracks_;
};

std::vector<PositionFix> TrackEpochs(const std::vector<Epoch>& epochs, std::size_t radios,
                                     MufafStage stage, const MufafSettings& settings) {
  Tracks tracks(settings, stage == MufafStage::kTrackFusion, radios);
  const bool smooths = stage != MufafStage::kTrack && settings.alpha > 0;
  std::optional<AlphaBetaFilter> smoother;
  if (smooths) smoother.emplace(settings.alpha);
  std::vector<PositionFix> fixes;
  TimeNs last_ns = epochs.front().front().time_ns;
  for (const Epoch& epoch : epochs) {
    PositionFix fix;
    fix.time_ns = epoch.front().time_ns;
    const double seconds = SecondsBetween(last_ns, fix.time_ns);
    last_ns = fix.time_ns;
    const KalmanState<4> state = tracks.Advance(epoch, seconds);
    fix.position_m = state.mean.head<2>();
    fix.covariance_m2 = state.covariance.topLeftCorner<2, 2>();
    if (smoother) fix.position_m = smoother->Advance(fix.position_m, seconds);
    fixes.push_back(fix);
  }
  return fixes;
}

std::vector<PositionFix> FixesOfFirstRadio(const std::vector<RadioReport>& reports) {
  std::vector<PositionFix> fixes;
  for (const RadioReport& report : reports) {
    PositionFix fix;
    fix.time_ns = report.time_ns;
    fix.position_m = report.fix.position_m;
    fixes.push_back(fix);
  }
  return fixes;
}

}  // namespace

double MufafEstimator::FixError(const CellMap& cells,
                                const CellEstimatorSettings& estimator) const {
  // Positions as they are estimated claim no error, and it takes longer than they do.
  if (method_.stage == MufafStage::kEstimate) return 0;
  if (settings_.fix_error_m > 0) return settings_.fix_error_m;
  return LeaveOneCellOutError(cells, estimator, kCellsForError);
}

EstimateResult MufafEstimator::Estimate(const Site& site, const Evidence& evidence) const {
  const DeadReckonedPath path = DeadReckon(site, evidence, factors_);
  const int floor = WalkFloor(site, evidence, wknn_);
  const CellEstimatorSettings estimator{method_.estimator, settings_.bandwidth_db,
                                        settings_.neighbours};
  const bool fuses =
      method_.stage == MufafStage::kTrackFusion || method_.stage == MufafStage::kGroupFusion;
  std::vector<RadioReport> reports;
  std::size_t radios = 0;
  for (const Radio radio : kAllRadios) {
    if (!factors_.fingerprint.Uses(radio) || (radios > 0 && !fuses)) continue;
    const SiteCells cells(site, floor, radio, settings_.cell_m, wknn_.max_age_s, wknn_.missing_dbm);
    if (cells.map().size() < 2) continue;
    const double error_m = FixError(cells.map(), estimator);
    const std::vector<QueryScan> scans = CollectQueryScans(site, evidence, wknn_.max_age_s, radio);
    const auto found = LocateRadio(cells, scans, radios, estimator, error_m);
    if (found.empty()) continue;
    reports.insert(reports.end(), found.begin(), found.end());
    ++radios;
  }
  if (reports.empty()) {
    return UnlocatedResult(site, evidence, path, "no anchor heard that the survey knows");
  }
  std::vector<PositionFix> fixes =
      method_.stage == MufafStage::kEstimate
          ? FixesOfFirstRadio(reports)
          : TrackEpochs(GroupReports(std::move(reports), settings_.window_s), radios, method_.stage,
                        settings_);
  for (PositionFix& fix : fixes) fix.floor = floor;
  EstimateResult result;
  result.trajectory = TrajectoryFromFixes(site, evidence, path, fixes);
  return result;
}

}  // namespace walkgraph
