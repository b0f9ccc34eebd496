#include "solvers/graph_solver.h"

#include <ceres/problem.h>
#include <ceres/solver.h>

#include <cmath>
#include <numeric>

namespace walkgraph {
namespace {

ceres::Problem::Options ProblemOptions() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;  // FactorGraph checks blocks against cost functions
  return options;
}

ceres::Solver::Options SolverOptions(const SolverSettings& settings) {
  ceres::Solver::Options options;
  options.num_threads = 1;
  options.max_num_iterations = settings.max_iterations;
  options.function_tolerance = settings.function_tolerance;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  options.max_solver_time_in_seconds = 1e9;  // iterations are the only limit
  options.logging_type = ceres::SILENT;
  return options;
}

void AddBlocks(const std::vector<int>& blocks, FactorGraph* graph, ceres::Problem* problem,
               std::vector<double*>* pointers) {
  pointers->clear();
  for (const int block : blocks) {
    pointers->push_back(graph->value(block));
    problem->AddParameterBlock(graph->value(block), graph->block(block).size());
    if (graph->block(block).constant) problem->SetParameterBlockConstant(graph->value(block));
  }
}

}  // namespace

SolveResult SolveGraph(const std::vector<int>& factors, const LinearPrior* prior,
                       const SolverSettings& settings, FactorGraph* graph) {
  const Eigen::VectorXd before = graph->values();
  ceres::Problem problem(ProblemOptions());
  std::vector<double*> pointers;
  for (const int index : factors) {
    const GraphFactor& factor = graph->factor(index);
    AddBlocks(factor.blocks, graph, &problem, &pointers);
    problem.AddResidualBlock(factor.cost.get(), factor.loss.get(), pointers);
  }
  std::unique_ptr<LinearPriorCost> prior_cost;
  if (prior != nullptr && !prior->empty()) {
    prior_cost = std::make_unique<LinearPriorCost>(*prior, *graph);
    AddBlocks(prior->blocks, graph, &problem, &pointers);
    problem.AddResidualBlock(prior_cost.get(), nullptr, pointers);
  }
  ceres::Solver::Summary summary;
  ceres::Solve(SolverOptions(settings), &problem, &summary);
  const bool ok = summary.IsSolutionUsable() && std::isfinite(summary.final_cost) &&
                  graph->values().allFinite();
  if (!ok) graph->SetValues(before);
  return {ok, static_cast<int>(summary.iterations.size())};
}

SolveResult SolveGraph(const SolverSettings& settings, FactorGraph* graph) {
  std::vector<int> all(graph->factors().size());
  std::iota(all.begin(), all.end(), 0);
  return SolveGraph(all, nullptr, settings, graph);
}

}  // namespace walkgraph
