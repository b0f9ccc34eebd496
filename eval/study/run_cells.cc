#include "eval/study/run_cells.h"

#include <algorithm>
#include <chrono>
#include <cstddef>

#include "eval/config.h"
#include "eval/run_walk.h"
#include "eval/survey_distance.h"
#include "frontends/radio_map/reading_lag.h"

namespace walkgraph {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<StudyWaypoint> DescribeWaypoints(const Truth& truth, const Evidence& evidence) {
  std::vector<StudyWaypoint> described;
  double distance_m = 0;
  for (std::size_t i = 0; i < truth.waypoints.size(); ++i) {
    const Waypoint& waypoint = truth.waypoints[i];
    if (i > 0) distance_m += (waypoint.position - truth.waypoints[i - 1].position).norm();
    const auto next = std::upper_bound(
        evidence.readings.begin(), evidence.readings.end(), waypoint.time_ns,
        [](TimeNs time, const RadioReading& reading) { return time < reading.heard_ns; });
    const double since_s = next == evidence.readings.begin()
                               ? std::numeric_limits<double>::quiet_NaN()
                               : SecondsBetween(std::prev(next)->heard_ns, waypoint.time_ns);
    described.push_back(
        {SecondsBetween(evidence.begin_ns, waypoint.time_ns), waypoint.floor, distance_m, since_s});
  }
  return described;
}

// `evidence` is the walk's, aligned to the site.
CellResult RunCell(const FoldCell& cell, const Site& site, const LoadedWalk& walk,
                   const Evidence& evidence) {
  CellResult result;
  result.cell = cell.name;
  result.configuration = cell.configuration;
  if (!walk.error.empty()) {
    result.status = EstimateStatus::kInputError;
    result.messages = {walk.error};
    return result;
  }
  const EstimateResult estimate = RunMethod(*cell.estimator, site, evidence, walk.truth);
  result.status = estimate.status;
  result.messages = estimate.messages;
  if (!estimate.trajectory.empty() && estimate.status != EstimateStatus::kUnobservable) {
    result.errors = ErrorsAtWaypoints(estimate.trajectory, walk.truth, cell.waypoint_sigma_m);
  }
  return result;
}

}  // namespace

std::vector<FoldCell> MakeFoldCells(const Study& study, const std::vector<std::size_t>& cells,
                                    const Fold& fold) {
  std::vector<FoldCell> made;
  for (const std::size_t index : cells) {
    const StudyCell& cell = study.cells[index];
    Settings settings = fold.settings;
    ApplyOverrides(EstimatorOverrides(cell.overrides), &settings);
    made.push_back({cell.name, ConfigurationHash(study, cell), cell.method->make(settings),
                    settings.scoring.waypoint_sigma_m});
  }
  return made;
}

CellsRun RunCells(const std::vector<FoldCell>& cells, const Site& site, const LoadedWalk& walk,
                  int fold, const WalkCells* earlier, const std::function<bool()>& stopped) {
  const Evidence evidence = AlignReadings(site, walk.evidence);
  CellsRun run;
  run.walk.walk = walk.file.id;
  run.walk.fold = fold;
  run.walk.device = walk.evidence.device;
  run.walk.duration_s = SecondsBetween(walk.evidence.begin_ns, walk.evidence.end_ns);
  run.walk.survey_distance_m = SurveyDistance(site, walk.truth);
  run.walk.error = walk.error;
  run.walk.waypoints = DescribeWaypoints(walk.truth, evidence);
  run.walk.centroid_errors = CentroidErrors(site, walk);
  for (const FoldCell& cell : cells) {
    const CellResult* known =
        earlier == nullptr ? nullptr : FindCell(*earlier, cell.name, cell.configuration);
    if (known != nullptr) {
      run.walk.cells.push_back(*known);
      continue;
    }
    if (stopped()) continue;
    const Clock::time_point begin = Clock::now();
    run.walk.cells.push_back(RunCell(cell, site, walk, evidence));
    run.seconds.emplace_back(cell.name,
                             std::chrono::duration<double>(Clock::now() - begin).count());
  }
  return run;
}

}  // namespace walkgraph
