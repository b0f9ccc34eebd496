#include "solvers/baselines/hipe.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "factors/dead_reckoning.h"
#include "solvers/baselines/discrete.h"

namespace walkgraph {
namespace {

std::vector<std::uint32_t> HeardTransmitters(const std::vector<QueryScan>& scans) {
  std::set<std::uint32_t> heard;
  for (const QueryScan& scan : scans) {
    for (const SignalVector::Entry& entry : scan.signal.entries) heard.insert(entry.transmitter);
  }
  return {heard.begin(), heard.end()};
}

std::span<const Polygon> Obstacles(const Site& site, int floor_number) {
  for (const Floor& floor : site.building.floors) {
    if (floor.number == floor_number) return floor.obstacles;
  }
  return {};
}

// Mass of the posterior at its maximum and the eight points around it.
double EstimateConfidence(const ReferencePoints& points, const std::vector<double>& posterior) {
  const auto best = static_cast<std::size_t>(ArgMax(posterior));
  double mass = 0;
  for (int row = -1; row <= 1; ++row) {
    for (int column = -1; column <= 1; ++column) {
      const ReferencePoints::Cell& cell = points.cell(best);
      const int near = points.IndexAt({cell.column + column, cell.row + row});
      if (near >= 0) mass += posterior[static_cast<std::size_t>(near)];
    }
  }
  return std::min(1.0, mass);
}

// Share of [begin_ns, end_ns] that the motion state is `state`.
double ShareOf(MotionState state, const Evidence& evidence, TimeNs begin_ns, TimeNs end_ns) {
  double seconds = 0;
  for (const MotionInterval& interval : evidence.motion) {
    if (interval.state != state) continue;
    seconds += std::max(0.0, SecondsBetween(std::max(begin_ns, interval.begin_ns),
                                            std::min(end_ns, interval.end_ns)));
  }
  const double span_s = SecondsBetween(begin_ns, end_ns);
  return span_s > 0 ? seconds / span_s : 0.0;
}

// Probability that the heading is within its tolerance, from the sensor's sigma and the offset's.
double HeadingConfidence(const Evidence& evidence, const MotionInformation& motion, TimeNs begin_ns,
                         double offset_sigma_rad) {
  if (!motion.heading_rad) return 1;
  const std::vector<TimeNs>& times = evidence.absolute_heading_rad.time_ns;
  const auto after = std::lower_bound(times.begin(), times.end(), begin_ns) - times.begin();
  const std::size_t i = std::min(static_cast<std::size_t>(after), times.size() - 1);
  const double sigma = std::hypot(evidence.absolute_heading_sigma_rad[i], offset_sigma_rad);
  return sigma > 0 ? std::erf(motion.heading_tolerance_rad / (sigma * std::numbers::sqrt2)) : 1.0;
}

double MotionConfidence(const Evidence& evidence, const MotionInformation& motion, TimeNs begin_ns,
                        TimeNs end_ns, double offset_sigma_rad) {
  const double undisturbed = 1 - ShareOf(MotionState::kHandling, evidence, begin_ns, end_ns);
  return undisturbed * HeadingConfidence(evidence, motion, begin_ns, offset_sigma_rad);
}

}  // namespace

double AdaptiveK(double estimate, double motion, const HipeSettings& settings) {
  const double confidence = std::clamp(estimate * motion, 0.0, 1.0);
  return settings.k_min * std::pow(settings.k_max / settings.k_min, confidence);
}

// One walk on one floor, from scans to a posterior per epoch.
class HipeEstimator::Run {
 public:
  Run(const HipeEstimator& hipe, const Site& site, const Evidence& evidence,
      const DeadReckonedPath& path, const ReferencePoints& points, std::vector<QueryScan> scans,
      int floor)
      : hipe_(hipe),
        site_(site),
        evidence_(evidence),
        path_(path),
        points_(points),
        scans_(std::move(scans)),
        floor_(floor),
        emission_(site, floor, points, HeardTransmitters(scans_), hipe.wknn_.max_age_s,
                  hipe.settings_.emission),
        pairs_(points, Obstacles(site, floor), hipe.settings_.motion.distance,
               hipe.settings_.motion.max_distance_m) {}

  std::vector<PositionFix> Solve() {
    const std::vector<double> start(points_.size(), 1 / static_cast<double>(points_.size()));
    std::vector<double> likelihood = Emission(0);
    std::vector<double> posterior = UpdateDistribution(start, likelihood);
    std::vector<double> score = likelihood;
    std::vector<std::vector<int>> from;
    std::vector<PositionFix> fixes{FilterFix(0, posterior)};
    for (std::size_t k = 1; k < scans_.size(); ++k) {
      const TransitionRows rows = Transition(k, posterior);
      likelihood = Emission(k);
      posterior = UpdateDistribution(PredictDistribution(rows, posterior), likelihood);
      fixes.push_back(FilterFix(k, posterior));
      if (hipe_.solver_ == HipeSolver::kFilter) continue;
      ViterbiStep step = AdvanceViterbi(rows, score);
      score = std::move(step.log_score);
      for (std::size_t i = 0; i < score.size(); ++i) score[i] += likelihood[i];
      from.push_back(std::move(step.from));
    }
    return hipe_.solver_ == HipeSolver::kFilter ? fixes : ViterbiFixes(TraceViterbi(from, score));
  }

 private:
  std::vector<double> Emission(std::size_t k) const {
    std::vector<double> likelihood = emission_.LogLikelihood(scans_[k].signal);
    if (!hipe_.settings_.emission.use_effective_readings) return likelihood;
    const RadioMap* map = site_.FindMap(floor_, Radio::kWifi);
    const double configured = hipe_.factors_.fingerprint.n_eff;
    const double n_eff = configured > 0 ? configured : map != nullptr ? map->n_eff : 0.0;
    const auto n = static_cast<double>(scans_[k].signal.entries.size());
    if (n_eff <= 0 || n_eff >= n) return likelihood;
    for (double& value : likelihood) value *= n_eff / n;
    return likelihood;
  }

  // From epoch k - 1 to k; the filter's last posterior says how sure the estimate is.
  TransitionRows Transition(std::size_t k, const std::vector<double>& posterior) const {
    const TimeNs begin = scans_[k - 1].time_ns, end = scans_[k].time_ns;
    const StepScaleSettings& scale = hipe_.factors_.step_scale;
    const MotionInformation motion =
        MeasureMotion(evidence_, path_, scale.mode == StateMode::kAbsent ? 1.0 : scale.prior_mean,
                      begin, end, points_.spacing_m(), hipe_.settings_.motion);
    const bool standing = motion.distance_m && *motion.distance_m == 0 &&
                          ShareOf(MotionState::kStanding, evidence_, begin, end) > 0.5;
    const double motion_confidence = MotionConfidence(
        evidence_, motion, begin, end, hipe_.factors_.heading_offset.prior_sigma_rad);
    const double k_ratio = standing ? hipe_.settings_.k_max
                                    : AdaptiveK(EstimateConfidence(points_, posterior),
                                                motion_confidence, hipe_.settings_);
    return HipeTransition(pairs_.Find(motion), k_ratio);
  }

  PositionFix FixAt(std::size_t k, int point) const {
    PositionFix fix;
    fix.time_ns = scans_[k].time_ns;
    fix.position_m = points_.positions_m()[static_cast<std::size_t>(point)];
    fix.floor = floor_;
    return fix;
  }

  // The covariance is about the reported point, the size of a lattice cell included.
  PositionFix FilterFix(std::size_t k, const std::vector<double>& posterior) const {
    PositionFix fix = FixAt(k, ArgMax(posterior));
    const double cell_variance = points_.spacing_m() * points_.spacing_m() / 12;
    fix.covariance_m2 = SecondMoment(points_.positions_m(), posterior, fix.position_m) +
                        cell_variance * Eigen::Matrix2d::Identity();
    return fix;
  }

  std::vector<PositionFix> ViterbiFixes(const std::vector<int>& states) const {
    std::vector<PositionFix> fixes;
    for (std::size_t k = 0; k < states.size(); ++k) fixes.push_back(FixAt(k, states[k]));
    return fixes;
  }

  const HipeEstimator& hipe_;
  const Site& site_;
  const Evidence& evidence_;
  const DeadReckonedPath& path_;
  const ReferencePoints& points_;
  std::vector<QueryScan> scans_;
  int floor_;
  HipeEmission emission_;
  ReferencePairs pairs_;
};

EstimateResult HipeEstimator::Estimate(const Site& site, const Evidence& evidence) const {
  const DeadReckonedPath path = DeadReckon(site, evidence, factors_);
  const int floor = WalkFloor(site, evidence, wknn_);
  const ReferencePoints points(site, floor, settings_.points);
  if (points.empty()) {
    return UnlocatedResult(site, evidence, path, "no survey of floor " + std::to_string(floor));
  }
  std::vector<QueryScan> scans = CollectQueryScans(site, evidence, wknn_.max_age_s);
  if (scans.empty()) {
    return UnlocatedResult(site, evidence, path, "no Wi-Fi scan that the survey knows");
  }
  EstimateResult result;
  const bool needs_heading = settings_.motion.motion_case == HipeCase::kDistanceHeading ||
                             settings_.motion.motion_case == HipeCase::kHeadingSpeed;
  if (needs_heading && path.source != HeadingSource::kAbsolute) {
    result.messages.emplace_back("no absolute heading: motion without direction");
  }
  Run run(*this, site, evidence, path, points, std::move(scans), floor);
  result.trajectory = TrajectoryFromFixes(site, evidence, path, run.Solve());
  return result;
}

}  // namespace walkgraph
