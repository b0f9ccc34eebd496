#include "graph/walk_graph.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "factors/absolute_heading.h"
#include "factors/area.h"
#include "factors/heading_increment.h"
#include "factors/loss.h"
#include "factors/position_hold.h"
#include "factors/prior.h"
#include "factors/step.h"
#include "graph/absolute_positions.h"
#include "graph/check_settings.h"
#include "graph/heights.h"
#include "graph/motion_model.h"
#include "graph/node_times.h"
#include "graph/slow_states.h"

namespace walkgraph {
namespace {

class WalkGraphBuilder {
 public:
  WalkGraphBuilder(const Site& site, const Evidence& evidence, const FactorSettings& settings,
                   const FloorPath& floors)
      : site_(site), evidence_(evidence), settings_(settings) {
    walk_.floors = floors;
    walk_.node_ns = GraphNodeTimes(evidence);
    for (const TimeNs time : walk_.node_ns) {
      walk_.level_m.push_back(HeightOfFloor(site, floors.At(time)));
    }
  }

  WalkGraph Build() && {
    AddNodes();
    AddHeights(evidence_, settings_, &walk_);
    AddMotion();
    AddTurns();
    AddAbsoluteHeadings();
    AddAbsolutePositions(site_, evidence_, settings_, &walk_);
    AddAreas();
    walk_.prior_values = walk_.graph.values();
    return std::move(walk_);
  }

 private:
  std::size_t nodes() const { return walk_.node_ns.size(); }
  TimeNs begin_ns() const { return walk_.node_ns.front(); }
  TimeNs end_ns() const { return walk_.node_ns.back(); }

  void Add(GraphFactor factor, const LossSettings& loss, TimeNs arrival_ns) {
    factor.loss = MakeLoss(loss, factor.cost->num_residuals());
    factor.arrival_ns = arrival_ns;
    walk_.graph.AddFactor(std::move(factor));
  }

  void AddNodes() {
    const Eigen::Vector2d centre = FloorCentre(site_, walk_.floors.At(begin_ns()));
    for (std::size_t i = 0; i < nodes(); ++i) {
      const int index = static_cast<int>(i);
      walk_.position.push_back(
          walk_.graph.AddBlock({BlockKind::kPosition, index}, walk_.node_ns[i], centre));
      walk_.heading.push_back(walk_.graph.AddBlock({BlockKind::kHeading, index}, walk_.node_ns[i],
                                                   Eigen::VectorXd::Zero(1)));
    }
    walk_.graph.AddFactor(MakeGraphFactor(
        PositionAnchorFactor{centre.x(), centre.y(), settings_.prior.position_sigma_m},
        {walk_.position.front()}, std::string(kPositionPriorType)));
  }

  void AddMotion() {
    const std::vector<NodeMotion> motions = MotionBetweenNodes(walk_.node_ns, evidence_, settings_);
    const bool stepped = std::any_of(motions.begin(), motions.end(),
                                     [](const NodeMotion& motion) { return motion.stepped; });
    const StepScaleSettings& s = settings_.step_scale;
    const KnotBlocks scale =
        AddRandomWalkState({BlockKind::kStepScale, stepped ? s.mode : StateMode::kAbsent, 1.0,
                            s.prior_mean, s.prior_sigma, s.walk_per_sqrt_s, s.knot_s},
                           begin_ns(), end_ns(), &walk_.graph);
    walk_.walked_m = {walk_.node_ns, {0.0}};
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const NodeMotion& motion = motions[i];
      walk_.walked_m.value.push_back(walk_.walked_m.value.back() + motion.length_m);
      const int p0 = walk_.position[i], p1 = walk_.position[i + 1];
      if (motion.stepped) {
        Add(MakeGraphFactor(
                StepFactor{motion.length_m, motion.sigma_along_m, motion.sigma_across_m},
                {p0, walk_.heading[i], p1, walk_.heading[i + 1], scale.At(walk_.node_ns[i])}),
            settings_.step.loss, walk_.node_ns[i + 1]);
      } else {
        Add(MakeGraphFactor(PositionHoldFactor{HoldSigma(i, motion)}, {p0, p1}),
            settings_.standing.loss, walk_.node_ns[i + 1]);
      }
    }
  }

  // Who stands on an escalator is carried along: between levels standing says nothing.
  double HoldSigma(std::size_t i, const NodeMotion& motion) const {
    const TimeNs from = walk_.node_ns[i], to = walk_.node_ns[i + 1];
    if (walk_.floors.OnLevel(from + (to - from) / 2)) return motion.sigma_along_m;
    return std::max(motion.sigma_along_m, settings_.standing.unseen_mps * SecondsBetween(from, to));
  }

  // A gyroscope that ran all through the interval, in the phone's resting place on the body.
  bool TurnMeasured(std::size_t i) const {
    const Stream<double>& yaw = evidence_.gyro_yaw_rad;
    return settings_.heading_increment.enabled && !yaw.empty() &&
           walk_.node_ns[i] >= yaw.time_ns.front() - kMaxNodeGapNs &&
           walk_.node_ns[i + 1] <= yaw.time_ns.back() + kMaxNodeGapNs &&
           MotionStateAt(evidence_, walk_.node_ns[i]) != MotionState::kHandling &&
           MotionStateAt(evidence_, walk_.node_ns[i + 1]) != MotionState::kHandling;
  }

  void AddTurns() {
    const HeadingIncrementSettings& turn = settings_.heading_increment;
    const GyroBiasSettings& s = settings_.gyro_bias;
    const bool any = turn.enabled && !evidence_.gyro_yaw_rad.empty();
    const KnotBlocks bias =
        AddRandomWalkState({BlockKind::kGyroBias, any ? s.mode : StateMode::kAbsent, 0.0, 0.0,
                            s.prior_sigma_radps, s.walk_radps_per_sqrt_s, s.knot_s},
                           begin_ns(), end_ns(), &walk_.graph);
    for (std::size_t i = 0; i + 1 < nodes(); ++i) {
      const TimeNs from = walk_.node_ns[i], to = walk_.node_ns[i + 1];
      const double duration_s = SecondsBetween(from, to);
      HeadingIncrementFactor factor{0, 0, turn.unmeasured_rad_per_sqrt_s * std::sqrt(duration_s)};
      if (TurnMeasured(i)) {
        factor = {
            Interpolate(evidence_.gyro_yaw_rad, to) - Interpolate(evidence_.gyro_yaw_rad, from),
            duration_s, turn.sigma_rad_per_sqrt_s * std::sqrt(duration_s)};
      }
      Add(MakeGraphFactor(factor, {walk_.heading[i], walk_.heading[i + 1], bias.At(from)}),
          turn.loss, to);
    }
  }

  // Seconds of the walk that a node speaks for: half of either interval beside it.
  double NodeShareSeconds(std::size_t i) const {
    const TimeNs before = walk_.node_ns[i > 0 ? i - 1 : i];
    const TimeNs after = walk_.node_ns[std::min(i + 1, nodes() - 1)];
    return 0.5 * SecondsBetween(before, after);
  }

  // The absolute heading is sampled at the nodes. Samples closer than the correlation time repeat
  // one another: each then counts for its share of it.
  void AddAbsoluteHeadings() {
    const Stream<double>& headings = evidence_.absolute_heading_rad;
    const AbsoluteHeadingSettings& absolute = settings_.absolute_heading;
    walk_.has_absolute_heading = absolute.enabled && !headings.empty();
    const HeadingOffsetSettings& s = settings_.heading_offset;
    const KnotBlocks offset = AddRandomWalkState(
        {BlockKind::kHeadingOffset, walk_.has_absolute_heading ? s.mode : StateMode::kAbsent, 0.0,
         s.prior_mean_rad, s.prior_sigma_rad, s.walk_rad_per_sqrt_s, s.knot_s},
        begin_ns(), end_ns(), &walk_.graph);
    if (!walk_.has_absolute_heading) return;
    for (std::size_t i = 0; i < nodes(); ++i) {
      const TimeNs time = walk_.node_ns[i];
      if (time < headings.time_ns.front() - kMaxNodeGapNs ||
          time > headings.time_ns.back() + kMaxNodeGapNs ||
          MotionStateAt(evidence_, time) == MotionState::kHandling) {
        continue;
      }
      const auto at = std::lower_bound(headings.time_ns.begin(), headings.time_ns.end() - 1, time) -
                      headings.time_ns.begin();
      const double own = evidence_.absolute_heading_sigma_rad[static_cast<std::size_t>(at)];
      const double repeats =
          std::max(1.0, absolute.correlation_s / std::max(NodeShareSeconds(i), 1e-3));
      const AbsoluteHeadingFactor factor{
          Interpolate(headings, time) + site_.HeadingToBuilding(),
          std::sqrt((absolute.sigma_rad * absolute.sigma_rad + own * own) * repeats)};
      GraphFactor reading = MakeGraphFactor(factor, {walk_.heading[i], offset.At(time)});
      reading.reading = true;
      Add(std::move(reading), absolute.loss, time);
    }
  }

  void AddAreas() {
    WalkAreas areas(site_, settings_.area, walk_.floors);
    for (std::size_t i = 0; i < nodes(); ++i) {
      const AreaField* area = areas.At(walk_.node_ns[i]);
      if (area == nullptr) continue;
      // A node stands for its share of the walk, so that more nodes are no more evidence.
      const double sigma_m =
          settings_.area.sigma_m / std::sqrt(std::max(NodeShareSeconds(i), 1e-3));
      GraphFactor factor = MakeGraphFactor(AreaFactor{*area, sigma_m}, {walk_.position[i]});
      factor.arrival_ns = walk_.node_ns[i];
      factor.one_sided = true;
      factor.whitened_rows = 0;  // no measurement
      walk_.graph.AddFactor(std::move(factor));
    }
  }

  const Site& site_;
  const Evidence& evidence_;
  const FactorSettings& settings_;
  WalkGraph walk_;
};

}  // namespace

WalkGraph BuildWalkGraph(const Site& site, const Evidence& evidence, const FactorSettings& settings,
                         const FloorPath& floors) {
  CheckSettings(settings);
  return WalkGraphBuilder(site, evidence, settings, floors).Build();
}

std::vector<int> NodeBlocks(const WalkGraph& walk, std::size_t node) {
  std::vector<int> blocks = {walk.position[node], walk.heading[node]};
  if (!walk.height.empty()) blocks.push_back(walk.height[node]);
  return blocks;
}

double HeightOfFloor(const Site& site, int floor) {
  const Floor* found = site.building.FindFloor(floor);
  return found == nullptr ? 0.0 : found->height_m;
}

}  // namespace walkgraph
