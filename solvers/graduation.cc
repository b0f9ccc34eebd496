#include "solvers/graduation.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "factors/truncated_loss.h"

namespace walkgraph {
namespace {

constexpr double kMuFactor = 1.4;  // the paper's

struct Truncated {
  TruncatedLoss* loss = nullptr;
  const GraphFactor* factor = nullptr;
};

std::vector<Truncated> TruncatedFactors(const GraphPart& part, const FactorGraph& graph) {
  std::vector<Truncated> found;
  for (const int index : part.factors) {
    const GraphFactor& factor = graph.factor(index);
    if (auto* loss = dynamic_cast<TruncatedLoss*>(factor.loss.get())) {
      found.push_back({loss, &factor});
    }
  }
  return found;
}

// The factor's squared norm over its threshold.
double Excess(const Truncated& truncated, const FactorGraph& graph) {
  std::vector<const double*> blocks;
  for (const int block : truncated.factor->blocks) blocks.push_back(graph.value(block));
  Eigen::VectorXd residual(truncated.factor->cost->num_residuals());
  truncated.factor->cost->Evaluate(blocks.data(), residual.data(), nullptr);
  return residual.squaredNorm() / truncated.loss->threshold();
}

std::vector<double> Excesses(const std::vector<Truncated>& truncated, const FactorGraph& graph) {
  std::vector<double> excesses;
  for (const Truncated& one : truncated) excesses.push_back(Excess(one, graph));
  return excesses;
}

// Whether every factor is either whole or cut.
bool AllDecided(const std::vector<double>& excesses, double mu) {
  return std::none_of(excesses.begin(), excesses.end(), [mu](double excess) {
    return excess > mu / (mu + 1) && excess < (mu + 1) / mu;
  });
}

}  // namespace

SolveResult SolveGraduated(const GraphPart& part, const SolverSettings& settings,
                           FactorGraph* graph) {
  const std::vector<Truncated> truncated = TruncatedFactors(part, *graph);
  for (const Truncated& one : truncated) one.loss->SetParabola();
  SolveResult result = SolveGraph(part, settings, graph);
  std::vector<double> excesses = Excesses(truncated, *graph);
  const double worst = excesses.empty() ? 0.0 : *std::max_element(excesses.begin(), excesses.end());
  // Below half of the threshold mu would be negative: nothing is near the cut.
  double mu = 2 * worst > 1 ? std::min(1 / (2 * worst - 1), TruncatedLoss::kFinalMu)
                            : TruncatedLoss::kFinalMu;
  while (result.ok && mu < TruncatedLoss::kFinalMu) {
    for (const Truncated& one : truncated) one.loss->SetMu(mu);
    const SolveResult next = SolveGraph(part, settings, graph);
    result = {next.ok, result.iterations + next.iterations};
    excesses = Excesses(truncated, *graph);
    if (AllDecided(excesses, mu)) break;
    mu *= kMuFactor;
  }
  for (const Truncated& one : truncated) one.loss->SetMu(TruncatedLoss::kFinalMu);
  return result;
}

}  // namespace walkgraph
