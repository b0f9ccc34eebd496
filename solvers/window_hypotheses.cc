#include "solvers/window_hypotheses.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "data/angle.h"
#include "graph/graph_part.h"
#include "graph/posterior.h"

namespace walkgraph {
namespace {

void Weigh(const SolverSettings& solver, WalkGraph* walk, WindowHypothesis* hypothesis) {
  GoTo(*hypothesis, walk);
  const GraphPart& part = hypothesis->window.part();
  hypothesis->uncertainty = ComputeUncertainty(*walk, part, solver.map_error_test);
  hypothesis->negative_log_mass = NegativeLogModeMass(NegativeLogDensity(walk->graph, part),
                                                      hypothesis->uncertainty.log_det_hessian,
                                                      hypothesis->uncertainty.variables) +
                                  0.5 * hypothesis->window.left_log_determinant() +
                                  hypothesis->forgotten_nats;
}

void DropRepeated(const FactorGraph& graph, double distinct_m,
                  std::vector<WindowHypothesis>* hypotheses) {
  std::vector<WindowHypothesis> distinct;
  for (WindowHypothesis& hypothesis : *hypotheses) {
    const bool repeated =
        std::any_of(distinct.begin(), distinct.end(), [&](const WindowHypothesis& better) {
          return SamePath(graph, better.window.part(), hypothesis.values, better.values,
                          better.uncertainty, distinct_m);
        });
    if (!repeated) distinct.push_back(std::move(hypothesis));
  }
  *hypotheses = std::move(distinct);
}

}  // namespace

void GoTo(const WindowHypothesis& hypothesis, WalkGraph* walk) {
  walk->graph.SetValues(hypothesis.values);
  SetConditionals(hypothesis.conditionals, walk);
}

void WeighHypotheses(const SolverSettings& solver, double limit_nats, WalkGraph* walk,
                     std::vector<WindowHypothesis>* hypotheses) {
  for (WindowHypothesis& hypothesis : *hypotheses) Weigh(solver, walk, &hypothesis);
  std::stable_sort(hypotheses->begin(), hypotheses->end(),
                   [](const WindowHypothesis& a, const WindowHypothesis& b) {
                     return a.negative_log_mass < b.negative_log_mass;
                   });
  const double limit = hypotheses->front().negative_log_mass + limit_nats;
  // The best stays even where its mass is not finite.
  hypotheses->erase(std::remove_if(hypotheses->begin() + 1, hypotheses->end(),
                                   [limit](const WindowHypothesis& h) {
                                     return !(h.negative_log_mass <= limit);
                                   }),
                    hypotheses->end());
  DropRepeated(walk->graph, solver.distinct_m, hypotheses);
}

Eigen::MatrixXd MixtureCovariance(const FactorGraph& graph,
                                  const std::vector<WindowHypothesis>& hypotheses, int block) {
  const StateBlock& state = graph.block(block);
  std::vector<double> masses;
  for (const WindowHypothesis& hypothesis : hypotheses) {
    masses.push_back(hypothesis.negative_log_mass);
  }
  const std::vector<double> weights = MixtureWeights(masses);
  const Eigen::VectorXd best = hypotheses.front().values.segment(state.offset, state.size());
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(state.size(), state.size());
  for (std::size_t h = 0; h < hypotheses.size(); ++h) {
    Eigen::VectorXd apart = hypotheses[h].values.segment(state.offset, state.size()) - best;
    if (state.id.kind == BlockKind::kHeading) apart[0] = WrapAngle(apart[0]);
    covariance +=
        weights[h] * (hypotheses[h].uncertainty.covariance[static_cast<std::size_t>(block)] +
                      apart * apart.transpose());
  }
  return covariance;
}

}  // namespace walkgraph
