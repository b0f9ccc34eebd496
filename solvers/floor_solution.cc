#include "solvers/floor_solution.h"

#include <algorithm>

#include "graph/graph_part.h"
#include "solvers/floors.h"
#include "solvers/initial_trajectory.h"

namespace walkgraph {
namespace {

FloorSolution SolveFloor(const Site& site, const Evidence& evidence, const FactorSettings& factors,
                         const SolverSettings& settings, int floor) {
  FloorSolution solution{BuildWalkGraph(site, evidence, factors, floor),
                         {},
                         0,
                         UnknownReadingsCost(site, evidence, factors.fingerprint, floor)};
  const GraphPart whole = WholeGraph(solution.walk.graph);
  for (const InitialTrajectory& start :
       ProposeTrajectories(site, evidence, factors, settings, floor)) {
    solution.modes.push_back(
        SolveFrom(start, whole, settings, &solution.walk, &solution.failed_solves));
  }
  RankModes(settings, whole, &solution.walk, &solution.modes);
  return solution;
}

}  // namespace

std::vector<FloorSolution> SolveFloors(const Site& site, const Evidence& evidence,
                                       const FactorSettings& factors,
                                       const SolverSettings& settings) {
  std::vector<FloorSolution> solutions;
  for (const int floor : CandidateFloors(site, evidence)) {
    solutions.push_back(SolveFloor(site, evidence, factors, settings, floor));
  }
  std::stable_sort(solutions.begin(), solutions.end(),
                   [](const FloorSolution& a, const FloorSolution& b) {
                     return a.negative_log_mass() < b.negative_log_mass();
                   });
  return solutions;
}

}  // namespace walkgraph
