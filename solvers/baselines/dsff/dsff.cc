#include "solvers/baselines/dsff/dsff.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "factors/dead_reckoning.h"
#include "solvers/baselines/fixes.h"

namespace walkgraph {
namespace {

// Scans far apart would make a way that could lead anywhere: epochs without a scan between them.
constexpr double kLongestEpochS = 10;

std::vector<TimeNs> EpochTimes(const std::vector<QueryScan>& scans, double longest_s) {
  std::vector<TimeNs> times;
  for (const QueryScan& scan : scans) {
    if (!times.empty()) {
      const TimeNs last = times.back();
      const double span_s = SecondsBetween(last, scan.time_ns);
      if (span_s <= 0) continue;
      const int pieces = static_cast<int>(std::ceil(span_s / longest_s));
      for (int i = 1; i < pieces; ++i) times.push_back(last + (scan.time_ns - last) * i / pieces);
    }
    times.push_back(scan.time_ns);
  }
  return times;
}

// The floor that is given, else those that were surveyed.
std::vector<int> WalkFloors(const Site& site, const Evidence& evidence) {
  if (evidence.floor) return {*evidence.floor};
  std::set<int> floors;
  for (const SurveyPoint& point : site.path) floors.insert(point.floor);
  return {floors.begin(), floors.end()};
}

// Standard deviation per axis of the way between two cells whose middles stand for all of them.
double CellWaySigma(double spacing_m) { return spacing_m / std::sqrt(6.0); }

std::vector<PositionFix> FixesOf(const std::vector<int>& trace, const std::vector<TimeNs>& times,
                                 const DsffCells& cells) {
  std::vector<PositionFix> fixes(times.size());
  for (std::size_t e = 0; e < times.size(); ++e) {
    fixes[e].time_ns = times[e];
    fixes[e].position_m = cells.PositionOf(trace[e]);
    fixes[e].floor = cells.FloorOf(trace[e]).floor;
  }
  return fixes;
}

std::vector<Eigen::Vector2d> PathOf(const Trajectory& trajectory) {
  std::vector<Eigen::Vector2d> path;
  for (const PoseEstimate& pose : trajectory.poses) path.push_back(pose.position_m.head<2>());
  return path;
}

// The best cell of every epoch; where nothing was heard of the floors, that of the epoch before
// (the first that heard something, at the beginning).
DsffTrack MostLikelyCells(const AbsoluteEvidence& absolute) {
  std::vector<int> best;
  for (const std::vector<double>& log_likelihood : absolute.log_likelihood) {
    const auto [low, high] = std::minmax_element(log_likelihood.begin(), log_likelihood.end());
    best.push_back(*low < *high ? static_cast<int>(high - log_likelihood.begin()) : -1);
  }
  const auto heard = std::find_if(best.begin(), best.end(), [](int cell) { return cell >= 0; });
  int last = heard == best.end() ? 0 : *heard;
  for (int& cell : best) last = cell = cell < 0 ? last : cell;
  DsffTrack track;
  track.traces.push_back({0.0, std::move(best)});
  return track;
}

}  // namespace

std::string DsffEstimator::Lack(const Evidence& evidence, const DsffCells& cells) const {
  if (!method_.variant.moves) return "";
  if (evidence.motion.empty()) return "no accelerometer: no steps";
  if (evidence.gyro_yaw_rad.empty()) return "no gyroscope: no heading";
  if (evidence.absolute_heading_rad.empty()) {
    return "no absolute heading: the gyroscope does not know where it began";
  }
  const bool one_floor = cells.floors().size() < 2;
  if (one_floor && method_.variant.needs_floors()) {
    return "one floor, given or surveyed: pressure tells nothing";
  }
  if (!one_floor && evidence.barometric_height_m.empty()) {
    return "no barometer, and the floor is not known";
  }
  const auto same_height = [&](const DsffCells::FloorCells& floor) {
    return floor.height_m == cells.floors().front().height_m;
  };
  if (!one_floor && std::all_of(cells.floors().begin(), cells.floors().end(), same_height)) {
    return "the building does not know the heights of its floors";
  }
  return "";
}

RelativeSensors DsffEstimator::MakeSensors(const std::vector<DsffMotion>& motion) const {
  double steps = 0, distance_m = 0, ways = 0;
  for (const DsffMotion& way : motion) {
    if (way.steps <= 0) continue;
    steps += way.steps;
    distance_m += way.distance_m;
    ++ways;
  }
  // Of a way of average length; of one step where none was walked.
  const double cell_m = CellWaySigma(settings_.cells.spacing_m);
  const double step_m = steps > 0 ? distance_m / steps : 0.7;
  const double way_steps = ways > 0 ? std::max(1.0, steps / ways) : 1.0;
  double distance_sigma = settings_.distance_sigma_m, heading_sigma = settings_.heading_sigma_rad;
  if (distance_sigma <= 0) {
    distance_sigma = std::hypot(factors_.step_scale.prior_sigma * step_m, cell_m / way_steps);
  }
  if (heading_sigma <= 0) {
    heading_sigma =
        std::hypot(factors_.heading_offset.prior_sigma_rad, std::atan2(cell_m, step_m * way_steps));
  }
  const DsffVariant& variant = method_.variant;
  return {{distance_sigma, variant.learns_distance, settings_.error_block},
          {heading_sigma, variant.learns_heading, settings_.error_block},
          {settings_.height_sigma_m, variant.learns_height, settings_.error_block}};
}

DsffTrack DsffEstimator::Track(const Site& site, const DsffCells& cells,
                               const AbsoluteEvidence& absolute,
                               const std::vector<DsffMotion>& motion) const {
  if (!method_.variant.moves) return MostLikelyCells(absolute);
  std::optional<MapMatching> map_matching;
  if (settings_.map_matching) map_matching.emplace(site, cells, MapMatching::Settings());
  std::optional<DsffTrack> best;
  for (const DsffCells::FloorCells& floor : cells.floors()) {
    DsffTrack track =
        TrackByErrorBlocks(cells, absolute, motion, MakeSensors(motion), floor.height_m,
                           map_matching ? &*map_matching : nullptr, settings_);
    if (!best || track.traces.front().log_score > best->traces.front().log_score) {
      best = std::move(track);
    }
  }
  return *std::move(best);
}

EstimateResult DsffEstimator::Locate(const Site& site, const Evidence& evidence,
                                     const DsffCells& cells, const Trajectory& truth) const {
  const bool moves = method_.variant.moves;
  const Evidence turned = moves ? WithGyroscopeHeading(evidence) : evidence;
  const DeadReckonedPath path = DeadReckon(site, turned, factors_);
  std::vector<TimeNs> epochs =
      EpochTimes(CollectQueryScans(site, evidence, wknn_.max_age_s),
                 moves ? kLongestEpochS : std::numeric_limits<double>::infinity());
  if (epochs.empty()) {
    return UnlocatedResult(site, evidence, path, "no Wi-Fi scan that the survey knows");
  }
  const AbsoluteEvidence absolute = GatherAbsoluteEvidence(
      site, evidence, cells, std::move(epochs), factors_, settings_.map, wknn_.missing_dbm);
  std::vector<DsffMotion> motion = MeasureDsffMotion(evidence, path, absolute.time_ns);
  SubstituteTruth(truth, absolute.time_ns, method_.variant.truth, &motion);
  const DsffTrack track = Track(site, cells, absolute, motion);

  EstimateResult result;
  for (std::size_t i = 0; i < track.traces.size(); ++i) {
    const std::vector<PositionFix> fixes = FixesOf(track.traces[i].states, absolute.time_ns, cells);
    Trajectory trajectory = TrajectoryFromFixes(site, evidence, path, fixes);
    result.hypotheses.push_back(
        {"trace " + std::to_string(i + 1), -track.traces[i].log_score, i == 0, PathOf(trajectory)});
    if (i == 0) result.trajectory = std::move(trajectory);
  }
  result.slow_states = track.learnt;
  if (track.restarts > 0) {
    result.messages.push_back("the trace ended and began anew " + std::to_string(track.restarts) +
                              " times: no way led to the next epoch");
  }
  return result;
}

EstimateResult DsffEstimator::EstimateKnowing(const Trajectory& truth, const Site& site,
                                              const Evidence& evidence) const {
  const DsffCells cells(site, WalkFloors(site, evidence), settings_.cells);
  if (cells.size() == 0) {
    return UnlocatedResult(site, evidence, DeadReckon(site, evidence, factors_),
                           "no survey of the floor");
  }
  EstimateResult result;
  const std::string lack = uses_truth() && truth.empty()
                               ? std::string("no truth, which stands in for a sensor here")
                               : Lack(evidence, cells);
  if (!lack.empty()) {
    result.status = EstimateStatus::kUnsupported;
    result.messages.push_back(lack);
    return result;
  }
  Trajectory with_heights = truth;
  for (PoseEstimate& pose : with_heights.poses) {
    pose.position_m.z() = FloorHeight(site, pose.floor);
  }
  return Locate(site, evidence, cells, with_heights);
}

EstimateResult DsffEstimator::Estimate(const Site& site, const Evidence& evidence) const {
  return EstimateKnowing({}, site, evidence);
}

}  // namespace walkgraph
