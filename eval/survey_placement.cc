#include "eval/survey_placement.h"

#include <cstddef>
#include <optional>
#include <utility>

#include "eval/table.h"
#include "frontends/radio_map/survey_positions.h"
#include "solvers/anchored_smoother.h"

namespace walkgraph {

SurveyPlacement PlaceSurveyWalk(const Building& building, const Truth& truth,
                                const Evidence& evidence, const Settings& settings) {
  const bool smooth = settings.survey.positions == SurveyPositions::kSmoother;
  if (smooth) {
    const AnchoredSmoother smoother(settings.factors, settings.solver,
                                    settings.scoring.waypoint_sigma_m);
    std::optional<Trajectory> trajectory = smoother.Smooth(building, truth, evidence);
    if (trajectory) return {std::move(*trajectory), false};
  }
  return {SurveyTrajectory(truth, evidence), smooth};
}

std::vector<WaypointError> LeftOutErrors(const Building& building, const Truth& truth,
                                         const Evidence& evidence, const Settings& settings) {
  Truth told{truth.frame, {}}, left_out{truth.frame, {}};
  const std::size_t count = truth.waypoints.size();
  for (std::size_t i = 0; i < count; ++i) {
    const bool inner = i > 0 && i + 1 < count;
    (inner && i % 2 == 1 ? left_out : told).waypoints.push_back(truth.waypoints[i]);
  }
  if (left_out.waypoints.empty()) return {};
  return ErrorsAtWaypoints(PlaceSurveyWalk(building, told, evidence, settings).trajectory, left_out,
                           settings.scoring.waypoint_sigma_m);
}

std::string FormatLeftOut(const std::vector<LeftOutRow>& rows) {
  Table table({"positions at left-out waypoints", "n", "mean m", "median m", "p90 m", "in 95 %"});
  for (const LeftOutRow& row : rows) {
    const ErrorSummary summary = Summarise(row.errors);
    table.AddRow({row.positions, std::to_string(summary.n), FixedDecimals(summary.mean_m, 2),
                  FixedDecimals(summary.median_m, 2), FixedDecimals(summary.p90_m, 2),
                  FixedDecimals(100 * summary.coverage95, 1) + " %"});
  }
  return table.Format();
}

}  // namespace walkgraph
