#include "eval/summary.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <set>
#include <utility>

#include "eval/survey_distance.h"
#include "eval/table.h"

namespace walkgraph {
namespace {

// Errors of the methods on one walk's selected waypoints: [method][waypoint].
using WalkErrors = std::vector<std::vector<WaypointError>>;

// The methods that placed any walk at all. One that could not (no sensor of its kind anywhere) has
// nothing to compare, and must not empty the pool of everybody else.
std::vector<std::size_t> MethodsThatRan(const Evaluation& evaluation) {
  std::vector<std::size_t> ran;
  for (std::size_t m = 0; m < evaluation.methods.size(); ++m) {
    if (std::any_of(evaluation.walks.begin(), evaluation.walks.end(), [m](const WalkOutcome& walk) {
          return walk.finished && walk.methods[m].has_trajectory;
        })) {
      ran.push_back(m);
    }
  }
  return ran;
}

bool HaveTrajectories(const WalkOutcome& walk, const std::vector<std::size_t>& methods) {
  return std::all_of(methods.begin(), methods.end(),
                     [&](std::size_t m) { return walk.methods[m].has_trajectory; });
}

template <typename T>
std::vector<T> Select(const std::vector<T>& values, const std::vector<std::size_t>& indices) {
  std::vector<T> selected;
  for (const std::size_t i : indices) selected.push_back(values[i]);
  return selected;
}

WalkErrors ErrorsOf(const WalkOutcome& walk) {
  WalkErrors errors;
  for (const MethodOutcome& method : walk.methods) {
    errors.push_back(method.has_trajectory ? method.errors : walk.centroid_errors);
  }
  return errors;
}

// The errors at the waypoints for which `selected`, indexed like them, holds.
WalkErrors AtWaypoints(const WalkErrors& walk, const std::vector<bool>& selected) {
  WalkErrors kept(walk.size());
  for (std::size_t m = 0; m < walk.size(); ++m) {
    for (std::size_t i = 0; i < walk[m].size(); ++i) {
      if (selected[i]) kept[m].push_back(walk[m][i]);
    }
  }
  return kept;
}

std::vector<bool> OnFloor(const WalkOutcome& walk, int floor) {
  std::vector<bool> selected;
  for (const Waypoint& waypoint : walk.truth.waypoints) {
    selected.push_back(waypoint.floor == floor);
  }
  return selected;
}

std::vector<bool> InMotion(const WalkOutcome& walk, MotionState state) {
  std::vector<bool> selected(walk.truth.waypoints.size(), false);
  for (std::size_t i = 0; i < walk.motion.size(); ++i) selected[i] = walk.motion[i] == state;
  return selected;
}

double SumOf(const std::vector<WaypointError>& errors) {
  double sum = 0;
  for (const WaypointError& error : errors) sum += error.error_m;
  return sum;
}

SummaryRow MakeRow(const std::string& method, std::size_t index,
                   const std::vector<WalkErrors>& walks) {
  SummaryRow row;
  row.method = method;
  row.walks = static_cast<int>(walks.size());
  std::vector<WaypointError> pooled;
  std::vector<WalkTotal> totals;
  for (const WalkErrors& walk : walks) {
    const std::vector<WaypointError>& errors = walk[index];
    pooled.insert(pooled.end(), errors.begin(), errors.end());
    totals.push_back({SumOf(errors), static_cast<int>(errors.size())});
  }
  row.errors = Summarise(pooled);
  row.mean_interval_m = BootstrapMean(totals);
  return row;
}

PairedDifference MakeDifference(const std::vector<std::string>& methods, std::size_t a,
                                std::size_t b, const std::vector<WalkErrors>& walks) {
  std::vector<WalkTotal> totals;
  for (const WalkErrors& walk : walks) {
    totals.push_back({SumOf(walk[a]) - SumOf(walk[b]), static_cast<int>(walk[a].size())});
  }
  return {methods[a], methods[b], PooledMean(totals), BootstrapMean(totals)};
}

SummarySection MakeSection(const std::string& name, const std::vector<std::string>& methods,
                           std::vector<WalkErrors> walks) {
  std::erase_if(walks, [](const WalkErrors& walk) { return walk.empty() || walk[0].empty(); });
  SummarySection section;
  section.name = name;
  for (std::size_t a = 0; a < methods.size(); ++a) {
    section.rows.push_back(MakeRow(methods[a], a, walks));
    for (std::size_t b = 0; b < methods.size(); ++b) {
      if (a != b) section.differences.push_back(MakeDifference(methods, a, b, walks));
    }
  }
  return section;
}

// A walk that counts in the pooled sections, with the errors of the methods that ran.
struct PooledWalk {
  const WalkOutcome* walk = nullptr;
  WalkErrors errors;
};

using Selection = std::function<std::vector<bool>(const WalkOutcome&)>;

SummarySection MakeSelection(const std::string& name, const std::vector<std::string>& methods,
                             const std::vector<PooledWalk>& pooled, const Selection& selection) {
  std::vector<WalkErrors> selected;
  for (const PooledWalk& walk : pooled) {
    selected.push_back(AtWaypoints(walk.errors, selection(*walk.walk)));
  }
  return MakeSection(name, methods, selected);
}

void AppendFloors(const std::vector<std::string>& methods, const std::vector<PooledWalk>& pooled,
                  const std::map<int, std::string>& floor_names,
                  std::vector<SummarySection>* sections) {
  std::set<int> floors;
  for (const PooledWalk& walk : pooled) {
    for (const Waypoint& waypoint : walk.walk->truth.waypoints) floors.insert(waypoint.floor);
  }
  for (const int floor : floors) {
    const auto name = floor_names.find(floor);
    const std::string title = name == floor_names.end() ? std::to_string(floor) : name->second;
    sections->push_back(
        MakeSelection("floor " + title, methods, pooled,
                      [floor](const WalkOutcome& walk) { return OnFloor(walk, floor); }));
  }
}

void AppendMotion(const std::vector<std::string>& methods, const std::vector<PooledWalk>& pooled,
                  std::vector<SummarySection>* sections) {
  std::vector<SummarySection> by_state;
  for (const auto& [name, state] :
       {std::pair("standing", MotionState::kStanding), {"walking", MotionState::kWalking}}) {
    by_state.push_back(MakeSelection(
        name, methods, pooled, [state](const WalkOutcome& walk) { return InMotion(walk, state); }));
    if (by_state.back().rows.empty() || by_state.back().rows.front().errors.n == 0) return;
  }
  sections->insert(sections->end(), by_state.begin(), by_state.end());
}

// `ran` is the index of each method in the walks' own list.
void AppendTrusted(const std::vector<std::string>& methods, const std::vector<std::size_t>& ran,
                   const std::vector<PooledWalk>& pooled, std::vector<SummarySection>* sections) {
  SummarySection section;
  section.name = "trusted";
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::vector<WalkErrors> selected;
    for (const PooledWalk& walk : pooled) {
      const std::vector<bool>& trusted = walk.walk->methods[ran[m]].trusted;
      if (std::find(trusted.begin(), trusted.end(), true) == trusted.end()) continue;
      selected.push_back(AtWaypoints(walk.errors, trusted));
    }
    if (!selected.empty()) section.rows.push_back(MakeRow(methods[m], m, selected));
  }
  if (!section.rows.empty()) sections->push_back(std::move(section));
}

}  // namespace

std::vector<SummarySection> SummariseEvaluation(const Evaluation& evaluation,
                                                const std::map<int, std::string>& floor_names) {
  const std::vector<std::size_t> ran = MethodsThatRan(evaluation);
  const std::vector<std::string> methods = Select(evaluation.methods, ran);
  std::vector<PooledWalk> pooled, covered;
  std::vector<WalkErrors> all;
  for (const WalkOutcome& walk : evaluation.walks) {
    if (!walk.finished || walk.truth.waypoints.empty()) continue;
    all.push_back(ErrorsOf(walk));
    if (ran.empty() || !HaveTrajectories(walk, ran)) continue;
    pooled.push_back({&walk, Select(all.back(), ran)});
    if (walk.survey_distance_m < kCoveredDistanceM) covered.push_back(pooled.back());
  }
  const Selection everywhere = [](const WalkOutcome& walk) {
    return std::vector<bool>(walk.truth.waypoints.size(), true);
  };
  std::vector<SummarySection> sections = {MakeSelection("pooled", methods, pooled, everywhere),
                                          MakeSelection("covered", methods, covered, everywhere)};
  AppendFloors(methods, pooled, floor_names, &sections);
  AppendMotion(methods, pooled, &sections);
  AppendTrusted(methods, ran, pooled, &sections);
  sections.push_back(MakeSection("all_walks", evaluation.methods, all));
  return sections;
}

std::string FormatSummary(const std::vector<SummarySection>& sections,
                          const std::map<std::string, double>& seconds_per_walk) {
  std::string text;
  for (const SummarySection& section : sections) {
    Table table({section.name, "walks", "n", "mean", "95% interval", "median", "p75", "p90", "p95",
                 "max", "floor", "ipin", "cover50", "cover95", "nees", "s/walk"});
    for (const SummaryRow& row : section.rows) {
      const ErrorSummary& e = row.errors;
      const auto seconds = seconds_per_walk.find(row.method);
      table.AddRow(
          {row.method, std::to_string(row.walks), std::to_string(e.n), FixedDecimals(e.mean_m, 2),
           FixedDecimals(row.mean_interval_m.low, 2) + " .. " +
               FixedDecimals(row.mean_interval_m.high, 2),
           FixedDecimals(e.median_m, 2), FixedDecimals(e.p75_m, 2), FixedDecimals(e.p90_m, 2),
           FixedDecimals(e.p95_m, 2), FixedDecimals(e.max_m, 1), FixedDecimals(e.floor_accuracy, 3),
           FixedDecimals(e.ipin_m, 2), FixedDecimals(e.coverage50, 3),
           FixedDecimals(e.coverage95, 3), FixedDecimals(e.nees, 2),
           seconds == seconds_per_walk.end() ? "-" : FixedDecimals(seconds->second, 3)});
    }
    text += table.Format() + "\n";
  }
  return text;
}

}  // namespace walkgraph
