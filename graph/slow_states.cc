#include "graph/slow_states.h"

#include <string>

#include "factors/prior.h"
#include "factors/random_walk.h"

namespace walkgraph {
namespace {

std::vector<int> AddKnots(BlockKind kind, const Knots& knots, const Eigen::VectorXd& value,
                          FactorGraph* graph) {
  std::vector<int> blocks;
  for (int k = 0; k < knots.count(); ++k) {
    blocks.push_back(graph->AddBlock({kind, k}, knots.Time(k), value));
  }
  return blocks;
}

KnotBlocks AddHeldState(BlockKind kind, const Eigen::VectorXd& value, TimeNs begin_ns,
                        FactorGraph* graph) {
  return {Knots(begin_ns, begin_ns, 1.0), {graph->AddBlock({kind, 0}, begin_ns, value, true)}};
}

std::string TypeOf(BlockKind kind, const char* what) {
  return std::string(BlockName(kind)) + "_" + what;
}

}  // namespace

KnotBlocks AddRandomWalkState(const RandomWalkModel& model, TimeNs begin_ns, TimeNs end_ns,
                              FactorGraph* graph) {
  const bool absent = model.mode == StateMode::kAbsent;
  const Eigen::VectorXd value =
      Eigen::VectorXd::Constant(1, absent ? model.absent_value : model.prior_mean);
  if (model.mode != StateMode::kActive) return AddHeldState(model.kind, value, begin_ns, graph);
  KnotBlocks state{Knots(begin_ns, end_ns, model.knot_s), {}};
  state.blocks = AddKnots(model.kind, state.knots, value, graph);
  graph->AddFactor(MakeGraphFactor(StatePriorFactor{model.prior_mean, model.prior_sigma},
                                   {state.blocks.front()}, TypeOf(model.kind, "prior")));
  const auto walk = RandomWalkFactor::FromRate(model.rate_per_sqrt_s, model.knot_s);
  for (std::size_t k = 1; k < state.blocks.size(); ++k) {
    graph->AddFactor(MakeGraphFactor(walk, {state.blocks[k - 1], state.blocks[k]},
                                     TypeOf(model.kind, "random_walk")));
  }
  return state;
}

int AddRssiOffsetState(const RssiOffsetPrior& prior, Radio radio, TimeNs begin_ns,
                       FactorGraph* graph) {
  constexpr BlockKind kKind = BlockKind::kRssiOffset;
  const bool held = prior.sigma_db <= 0;
  const int block = graph->AddBlock({kKind, static_cast<int>(radio)}, begin_ns,
                                    Eigen::VectorXd::Constant(1, prior.mean_db), held);
  if (!held) {
    graph->AddFactor(MakeGraphFactor(StatePriorFactor{prior.mean_db, prior.sigma_db}, {block},
                                     TypeOf(kKind, "prior")));
  }
  return block;
}

}  // namespace walkgraph
