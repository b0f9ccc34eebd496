#include "graph/heights.h"

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "factors/at_time.h"
#include "factors/barometric.h"
#include "factors/level.h"
#include "factors/loss.h"
#include "factors/random_walk.h"
#include "graph/node_times.h"
#include "graph/slow_states.h"

namespace walkgraph {
namespace {

void AddLevels(const LevelSettings& settings, WalkGraph* walk) {
  for (std::size_t i = 0; i < walk->node_ns.size(); ++i) {
    const TimeNs time = walk->node_ns[i];
    walk->height.push_back(walk->graph.AddBlock({BlockKind::kHeight, static_cast<int>(i)}, time,
                                                Eigen::VectorXd::Constant(1, walk->level_m[i])));
    const auto add = [&](GraphFactor factor) {
      factor.arrival_ns = time;
      walk->graph.AddFactor(std::move(factor));
    };
    if (walk->floors.OnLevel(time)) {
      add(MakeGraphFactor(LevelFactor{walk->level_m[i], settings.sigma_m}, {walk->height[i]}));
    }
    if (i == 0) continue;
    const auto climb = RandomWalkFactor::FromRate(settings.climb_m_per_sqrt_s,
                                                  SecondsBetween(walk->node_ns[i - 1], time));
    add(MakeGraphFactor(climb, {walk->height[i - 1], walk->height[i]},
                        std::string(BlockName(BlockKind::kHeight)) + "_random_walk"));
  }
}

void AddBarometer(const Evidence& evidence, const FactorSettings& settings, WalkGraph* walk) {
  const BarometricOffsetSettings& s = settings.barometric_offset;
  const KnotBlocks offset =
      AddRandomWalkState({BlockKind::kBarometricOffset, s.mode, 0.0, s.prior_mean_m,
                          s.prior_sigma_m, s.walk_m_per_sqrt_s, s.knot_s},
                         walk->node_ns.front(), walk->node_ns.back(), &walk->graph);
  const Stream<double>& heights = evidence.barometric_height_m;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const TimeNs time = heights.time_ns[i];
    if (time < walk->node_ns.front() || time > walk->node_ns.back()) continue;
    const double sigma_m =
        std::hypot(settings.barometric.sigma_m, evidence.barometric_height_sigma_m[i]);
    const NodeBracket bracket = FindBracket(walk->node_ns, time);
    const auto before = static_cast<std::size_t>(bracket.before);
    GraphFactor factor = MakeGraphFactor(BarometricFactor{heights.value[i], sigma_m},
                                         {walk->height[before], offset.At(time)});
    if (bracket.fraction > 0) {
      factor.cost = std::make_unique<AtTime<>>(bracket.fraction, std::move(factor.cost));
      factor.blocks.insert(factor.blocks.begin() + 1, walk->height[before + 1]);
    }
    factor.reading = true;
    factor.loss = MakeLoss(settings.barometric.loss, 1);
    factor.arrival_ns = time;
    walk->graph.AddFactor(std::move(factor));
  }
}

}  // namespace

void AddHeights(const Evidence& evidence, const FactorSettings& settings, WalkGraph* walk) {
  const bool measured = settings.barometric.enabled && !evidence.barometric_height_m.empty();
  if (!measured && walk->floors.stays().size() == 1) return;
  AddLevels(settings.level, walk);
  if (measured) AddBarometer(evidence, settings, walk);
}

}  // namespace walkgraph
