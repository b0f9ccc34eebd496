#include "solvers/describe.h"

#include <optional>

#include "graph/linearize.h"
#include "graph/observability.h"

namespace walkgraph {
namespace {

BlockLabel LabelOf(const StateBlock& block) {
  switch (block.id.kind) {
    case BlockKind::kPosition:
      return {"position", {"x", "y"}};
    case BlockKind::kHeading:
      return {"heading", {}};
    case BlockKind::kMapError:
      return {"map error", {"x", "y"}};
    case BlockKind::kMagneticError:
      return {"magnetic map error", {"x", "y"}};
    default:
      return {std::string(BlockName(block.id.kind)), {}};
  }
}

}  // namespace

std::vector<std::string> DescribeUnobservable(const WalkGraph& walk) {
  const VariableIndex index(walk.graph);
  std::vector<int> factors;
  for (std::size_t i = 0; i < walk.graph.factors().size(); ++i) {
    if (walk.graph.factors()[i].type != kPositionPriorType) factors.push_back(static_cast<int>(i));
  }
  const LinearSystem system =
      Linearize(walk.graph, factors, {walk.graph.values(), std::nullopt}, index);
  std::vector<BlockLabel> labels;
  for (int v = 0; v < index.size(); ++v) {
    labels.push_back(LabelOf(walk.graph.block(index.block(v))));
  }
  const std::optional<ObservabilityReport> report = AnalyzeObservability(system, labels);
  if (!report) return {"observability unknown: the graph is not finite"};
  return DescribeObservability(
      *report, {{"position", {"fingerprint", "position_anchor"}},
                {"heading", {"absolute_heading", "fingerprint", "position_anchor"}}});
}

std::vector<FactorStatistics> ToFactorStatistics(const std::vector<ResidualStatistics>& types) {
  std::vector<FactorStatistics> all;
  for (const ResidualStatistics& s : types) {
    all.push_back({s.type, s.count, s.dimension, s.mean_squared_whitened, s.downweighted});
  }
  return all;
}

EstimateResult Describe(WalkGraph& walk, const std::vector<Mode>& modes, double mode_limit_nats) {
  EstimateResult result;
  GoTo(modes.front(), &walk);
  result.trajectory = MixModes(walk, modes, mode_limit_nats);
  result.slow_states = SlowStates(walk, modes.front());
  result.hypotheses = Hypotheses(walk, modes, mode_limit_nats);
  result.factor_statistics = ToFactorStatistics(ComputeStatistics(walk.graph));
  for (const FactorFit& fit : ComputeFits(walk.graph)) {
    result.residuals.push_back(
        {fit.type, fit.time_ns, fit.count, fit.mean_squared_whitened, fit.downweighted});
  }
  if (!walk.first_absolute_position_ns) {
    result.status = EstimateStatus::kUnobservable;
    result.messages = DescribeUnobservable(walk);
  }
  if (!modes.front().values.allFinite()) result.status = EstimateStatus::kDiverged;
  return result;
}

}  // namespace walkgraph
