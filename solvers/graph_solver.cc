#include "solvers/graph_solver.h"

#include <ceres/problem.h>
#include <ceres/solver.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cmath>
#include <memory>
#include <vector>

namespace walkgraph {
namespace {

ceres::Problem::Options ProblemOptions() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;  // FactorGraph checks blocks against cost functions
  return options;
}

// Ends with the first step that changes the cost by less, whether it is taken or not. Ceres itself
// knows shares of the cost alone.
class EndBelowGain : public ceres::IterationCallback {
 public:
  explicit EndBelowGain(double least) : least_(least) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
    const bool tried = step.iteration > 0 && step.step_is_valid;
    return tried && std::abs(step.cost_change) < least_ ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                                                        : ceres::SOLVER_CONTINUE;
  }

 private:
  double least_;
};

ceres::Solver::Options SolverOptions(const SolverSettings& settings,
                                     ceres::IterationCallback* end_below_gain) {
  ceres::Solver::Options options;
  options.num_threads = 1;
  options.max_num_iterations = settings.max_iterations;
  options.callbacks = {end_below_gain};
  // These only end a search that can gain nothing in double precision.
  options.function_tolerance = 0;
  options.gradient_tolerance = 0;
  options.parameter_tolerance = 1e-15;
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

struct NormalEquations {
  Eigen::SparseMatrix<double> hessian;
  Eigen::VectorXd gradient;
};

NormalEquations MakeNormalEquations(const LinearSystem& system) {
  std::vector<Eigen::Index> first;
  Eigen::Index size = 0;
  for (const int block_size : system.block_sizes) {
    first.push_back(size);
    size += block_size;
  }
  NormalEquations equations{Eigen::SparseMatrix<double>(size, size), Eigen::VectorXd::Zero(size)};
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<Eigen::Index> columns;
  for (const LinearFactor& factor : system.factors) {
    columns.clear();
    for (const int block : factor.blocks) {
      const auto b = static_cast<std::size_t>(block);
      for (int i = 0; i < system.block_sizes[b]; ++i) columns.push_back(first[b] + i);
    }
    const Eigen::MatrixXd hessian = factor.jacobian.transpose() * factor.jacobian;
    const Eigen::VectorXd gradient = factor.jacobian.transpose() * factor.residual;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      equations.gradient[columns[i]] += gradient[static_cast<Eigen::Index>(i)];
      for (std::size_t j = 0; j < columns.size(); ++j) {
        entries.emplace_back(columns[i], columns[j],
                             hessian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
      }
    }
  }
  equations.hessian.setFromTriplets(entries.begin(), entries.end());
  return equations;
}

}  // namespace

SolveResult SolveGraph(const GraphPart& part, const SolverSettings& settings, FactorGraph* graph) {
  const Eigen::VectorXd before = graph->values();
  ceres::Problem problem(ProblemOptions());
  std::vector<double*> pointers;
  for (const int index : part.factors) {
    const GraphFactor& factor = graph->factor(index);
    AddBlocks(factor.blocks, graph, &problem, &pointers);
    problem.AddResidualBlock(factor.cost.get(), factor.loss.get(), pointers);
  }
  std::vector<std::unique_ptr<LinearPriorCost>> priors;
  for (const LinearPrior& prior : part.priors) {
    priors.push_back(std::make_unique<LinearPriorCost>(prior, *graph));
    AddBlocks(prior.blocks, graph, &problem, &pointers);
    problem.AddResidualBlock(priors.back().get(), nullptr, pointers);
  }
  ceres::Solver::Summary summary;
  EndBelowGain end_below_gain(settings.tolerance_nats);
  ceres::Solve(SolverOptions(settings, &end_below_gain), &problem, &summary);
  const bool ok = summary.IsSolutionUsable() && std::isfinite(summary.final_cost) &&
                  graph->values().allFinite();
  if (!ok) graph->SetValues(before);
  return {ok, static_cast<int>(summary.iterations.size())};
}

void PolishSolution(const GraphPart& part, FactorGraph* graph) {
  constexpr double kLargestCorrection = 1e-4;  // absolute; metres or radians
  const VariableIndex index(*graph, part.blocks);
  const NormalEquations equations = MakeNormalEquations(Linearize(*graph, part, index));
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt(equations.hessian);
  if (ldlt.info() != Eigen::Success) return;
  const Eigen::VectorXd step = ldlt.solve(-equations.gradient);
  if (!step.allFinite() || step.lpNorm<Eigen::Infinity>() > kLargestCorrection) return;
  Eigen::VectorXd values = graph->values();
  Eigen::Index at = 0;
  for (int v = 0; v < index.size(); ++v) {
    const StateBlock& block = graph->block(index.block(v));
    values.segment(block.offset, block.size()) += step.segment(at, block.size());
    at += block.size();
  }
  graph->SetValues(values);
}

}  // namespace walkgraph
