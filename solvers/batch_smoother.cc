#include "solvers/batch_smoother.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "graph/posterior.h"
#include "graph/walk_graph.h"
#include "solvers/describe.h"
#include "solvers/floors.h"
#include "solvers/graph_solver.h"
#include "solvers/initial_trajectory.h"
#include "solvers/modes.h"

namespace walkgraph {
namespace {

// A walk explained on one floor.
struct FloorSolution {
  WalkGraph walk;
  std::vector<Mode> modes;  // best first
  int failed_solves = 0;
  double unknown_nats = 0;  // see UnknownReadingsCost

  double negative_log_mass() const { return modes.front().negative_log_mass + unknown_nats; }
};

FloorSolution SolveFloor(const Site& site, const Evidence& evidence, const FactorSettings& factors,
                         const SolverSettings& settings, int floor) {
  FloorSolution solution{BuildWalkGraph(site, evidence, factors, floor),
                         {},
                         0,
                         UnknownReadingsCost(site, evidence, factors.fingerprint, floor)};
  FactorGraph& graph = solution.walk.graph;
  for (const InitialTrajectory& start :
       ProposeTrajectories(site, evidence, factors, settings, floor)) {
    SetTrajectory(start.trajectory, &solution.walk);
    // Without any absolute position the start is the answer: all that a solve could do is to pull
    // the walk's first node to the middle of the floor.
    if (solution.walk.first_absolute_position_ns && !SolveGraph(settings, &graph).ok) {
      ++solution.failed_solves;
    }
    solution.modes.push_back({start.source, graph.values(), NegativeLogDensity(graph), 0, {}});
  }
  RankModes(settings, &solution.walk, &solution.modes);
  return solution;
}

}  // namespace

EstimateResult BatchSmoother::Estimate(const Site& site, const Evidence& evidence) const {
  std::vector<FloorSolution> solutions;
  for (const int floor : CandidateFloors(site, evidence)) {
    solutions.push_back(SolveFloor(site, evidence, factors_, solver_, floor));
  }
  auto best = std::min_element(solutions.begin(), solutions.end(),
                               [](const FloorSolution& a, const FloorSolution& b) {
                                 return a.negative_log_mass() < b.negative_log_mass();
                               });
  EstimateResult result = Describe(site, best->walk, best->modes, solver_.mode_limit_nats);
  for (const FloorSolution& solution : solutions) {
    if (solution.failed_solves > 0) {
      result.messages.push_back("floor " + std::to_string(solution.walk.floor) + ": " +
                                std::to_string(solution.failed_solves) +
                                " solves failed and kept their starts");
    }
    if (&solution == &*best) continue;
    for (Hypothesis& other : Hypotheses(solution.walk, solution.modes, 0)) {
      other.kept = false;
      result.hypotheses.push_back(std::move(other));
    }
  }
  return result;
}

}  // namespace walkgraph
