#include "solvers/modes.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include "data/angle.h"
#include "frontends/evidence/barometric_formula.h"
#include "graph/linearize.h"
#include "graph/map_error_states.h"
#include "graph/marginal_covariance.h"
#include "graph/posterior.h"
#include "graph/variance_component.h"
#include "solvers/graduation.h"

namespace walkgraph {
namespace {

Eigen::Vector2d PositionOf(const WalkGraph& walk, const Eigen::VectorXd& values, std::size_t node) {
  return values.segment<2>(walk.graph.block(walk.position[node]).offset);
}

double HeightOf(const WalkGraph& walk, const Eigen::VectorXd& values, std::size_t node) {
  return walk.height.empty() ? walk.level_m[node]
                             : values[walk.graph.block(walk.height[node]).offset];
}

double HeadingOf(const WalkGraph& walk, const Eigen::VectorXd& values, std::size_t node) {
  return values[walk.graph.block(walk.heading[node]).offset];
}

std::size_t KeptCount(const std::vector<Mode>& modes, double mode_limit_nats) {
  std::size_t kept = 1;
  while (kept < modes.size() &&
         modes[kept].negative_log_mass <= modes.front().negative_log_mass + mode_limit_nats) {
    ++kept;
  }
  return kept;
}

std::vector<double> ModeWeights(const std::vector<Mode>& modes, std::size_t kept) {
  std::vector<double> masses;
  for (std::size_t m = 0; m < kept; ++m) masses.push_back(modes[m].negative_log_mass);
  return MixtureWeights(masses);
}

void MixNode(const WalkGraph& walk, const std::vector<Mode>& modes,
             const std::vector<double>& weights, std::size_t node, PoseEstimate* pose) {
  pose->covariance_xy_m2.setZero();
  pose->variance_heading_rad2 = 0;
  if (!walk.height.empty()) pose->variance_z_m2 = 0;
  for (std::size_t m = 0; m < weights.size(); ++m) {
    const Mode& mode = modes[m];
    const Eigen::Vector2d apart = PositionOf(walk, mode.values, node) - pose->position_m.head<2>();
    const double turned = WrapAngle(HeadingOf(walk, mode.values, node) - pose->heading_rad);
    const auto position = static_cast<std::size_t>(walk.position[node]);
    const auto heading = static_cast<std::size_t>(walk.heading[node]);
    pose->covariance_xy_m2 +=
        weights[m] * (mode.uncertainty.covariance[position] + apart * apart.transpose());
    pose->variance_heading_rad2 +=
        weights[m] * (mode.uncertainty.covariance[heading](0, 0) + turned * turned);
    if (walk.height.empty()) continue;
    const auto height = static_cast<std::size_t>(walk.height[node]);
    const double above = HeightOf(walk, mode.values, node) - pose->position_m.z();
    pose->variance_z_m2 += weights[m] * (mode.uncertainty.covariance[height](0, 0) + above * above);
  }
}

// Names of a slow state's coordinates.
std::vector<std::string> CoordinateNames(const StateBlock& block) {
  if (block.id.kind == BlockKind::kMapError) return {"map_error_x_m", "map_error_y_m"};
  if (block.id.kind == BlockKind::kMagneticError) {
    return {"magnetic_error_x_m", "magnetic_error_y_m"};
  }
  if (block.id.kind == BlockKind::kRssiOffset) {
    return {std::string("rssi_offset_") + RadioName(static_cast<Radio>(block.id.index)) + "_db"};
  }
  return {std::string(BlockName(block.id.kind))};
}

// Where nothing tells the heading, the part's first one is uniform on the circle.
void BoundFirstHeading(const WalkGraph& walk, const GraphPart& part, const VariableIndex& index,
                       LinearSystem* system) {
  if (walk.has_absolute_heading) return;
  const auto first_heading = std::find_if(
      part.blocks.begin(), part.blocks.end(),
      [&walk](int block) { return walk.graph.block(block).id.kind == BlockKind::kHeading; });
  if (first_heading == part.blocks.end()) return;
  const double sigma_rad = std::numbers::pi / std::sqrt(3.0);
  system->factors.push_back({{index.variable(*first_heading)},
                             Eigen::MatrixXd::Constant(1, 1, 1.0 / sigma_rad),
                             Eigen::VectorXd::Zero(1)});
}

// The heights and the barometer of a part, which nothing connects with the rest.
GraphPart HeightPart(const WalkGraph& walk, const GraphPart& part) {
  const auto is_height = [&walk](int block) {
    const BlockKind kind = walk.graph.block(block).id.kind;
    return kind == BlockKind::kHeight || kind == BlockKind::kBarometricOffset;
  };
  GraphPart heights;
  std::copy_if(part.blocks.begin(), part.blocks.end(), std::back_inserter(heights.blocks),
               is_height);
  std::copy_if(part.factors.begin(), part.factors.end(), std::back_inserter(heights.factors),
               [&](int factor) {
                 const std::vector<int>& blocks = walk.graph.factor(factor).blocks;
                 return std::all_of(blocks.begin(), blocks.end(), is_height);
               });
  return heights;
}

// Where the errors of maps have yet to be conditioned on the places of a mode, its first solve only
// says which mode that is: it may end at ten times the tolerance.
SolverSettings FirstSolve(const SolverSettings& settings, const WalkGraph& walk) {
  SolverSettings first = settings;
  if (!walk.map_errors.empty()) first.tolerance_nats *= 10;
  return first;
}

// Drops modes that no refinement brings back. It moves them against each other by some nats, a
// dozen at most among those within thirty of the best (38 walks of a museum, 2026-11-27).
void DropHopeless(double mode_limit_nats, std::vector<Mode>* modes) {
  const double limit = modes->front().negative_log_mass + 4 * mode_limit_nats;
  std::erase_if(*modes, [limit](const Mode& mode) { return mode.negative_log_mass > limit; });
}

std::vector<bool> BlocksOfKind(const WalkGraph& walk, const VariableIndex& index, BlockKind kind) {
  std::vector<bool> is_of_kind;
  for (int v = 0; v < index.size(); ++v) {
    is_of_kind.push_back(walk.graph.block(index.block(v)).id.kind == kind);
  }
  return is_of_kind;
}

// The marginals of a system, with the variance of its map errors that they show themselves where a
// test finds them larger than the model's.
std::optional<MarginalCovariance> UnderShownErrors(MarginalCovariance marginals,
                                                   const std::vector<bool>& is_map_error,
                                                   double map_error_test, LinearSystem* system) {
  const double inflation =
      EstimateVarianceComponent(*system, is_map_error, marginals).Inflation(map_error_test);
  if (inflation <= 1.0) return marginals;
  InflateVariance(inflation, is_map_error, system);
  return MarginalCovariance::Compute(*system);
}

// Of each block of the system, see WideningOfKnots; 1 for what is no map's error.
std::vector<double> WideningOfBlocks(const WalkGraph& walk, const GraphPart& part,
                                     const VariableIndex& index) {
  TimeNs now_ns = walk.node_ns.front();
  for (const int block : part.blocks) {
    if (walk.graph.block(block).id.kind != BlockKind::kPosition) continue;
    now_ns = std::max(now_ns, walk.graph.block(block).time_ns);
  }
  std::vector<double> widening(static_cast<std::size_t>(index.size()), 1.0);
  for (const MapErrorKnots& knots : walk.map_errors) {
    if (knots.widened_by.empty()) continue;
    const std::vector<double> of_knots = WideningOfKnots(knots, walk, now_ns);
    for (std::size_t k = 0; k < of_knots.size(); ++k) {
      const int variable = index.variable(knots.state.blocks[k]);
      if (variable >= 0) widening[static_cast<std::size_t>(variable)] = of_knots[k];
    }
  }
  return widening;
}

}  // namespace

bool SamePath(const FactorGraph& graph, const GraphPart& part, const Eigen::VectorXd& point,
              const Eigen::VectorXd& values, const PointUncertainty& uncertainty,
              double distinct_m) {
  double metres = 0, sigmas = 0;  // mean squares
  int nodes = 0;
  for (const int index : part.blocks) {
    const StateBlock& block = graph.block(index);
    if (block.id.kind != BlockKind::kPosition) continue;
    const Eigen::Vector2d apart = point.segment<2>(block.offset) - values.segment<2>(block.offset);
    const Eigen::Matrix2d covariance = uncertainty.covariance[static_cast<std::size_t>(index)];
    ++nodes;
    metres += (apart.squaredNorm() - metres) / nodes;
    sigmas += (0.5 * apart.dot(covariance.ldlt().solve(apart)) - sigmas) / nodes;
  }
  return metres < distinct_m * distinct_m || sigmas < 1.0;
}

std::vector<double> MixtureWeights(const std::vector<double>& negative_log_masses) {
  std::vector<double> weights;
  double sum = 0;
  for (const double mass : negative_log_masses) {
    // Equal infinities (covariance failed everywhere) leave the first alone.
    const double excess = weights.empty() ? 0.0 : mass - negative_log_masses.front();
    weights.push_back(std::isnan(excess) ? 0.0 : std::exp(-excess));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

PointUncertainty ComputeUncertainty(const WalkGraph& walk, const GraphPart& part,
                                    double map_error_test) {
  const VariableIndex index(walk.graph, part.blocks);
  LinearSystem system = Linearize(walk.graph, part, index);
  BoundFirstHeading(walk, part, index, &system);
  PointUncertainty result;
  for (const StateBlock& block : walk.graph.blocks()) {
    const int size = block.constant ? 0 : block.size();
    result.covariance.push_back(
        Eigen::MatrixXd::Constant(size, size, std::numeric_limits<double>::quiet_NaN()));
  }
  std::optional<MarginalCovariance> marginals = MarginalCovariance::Compute(system);
  if (!marginals) return result;
  result.log_det_hessian =
      marginals->log_determinant().value_or(std::numeric_limits<double>::infinity());
  const std::vector<bool> is_map_error = BlocksOfKind(walk, index, BlockKind::kMapError);
  marginals = UnderShownErrors(std::move(*marginals), is_map_error, map_error_test, &system);
  for (int v = 0; v < index.size(); ++v) {
    result.covariance[static_cast<std::size_t>(index.block(v))] = marginals->block(v).covariance;
    result.variables += system.block_sizes[static_cast<std::size_t>(v)];
  }
  return result;
}

void WidenOffSurvey(const WalkGraph& walk, const GraphPart& part, double map_error_test,
                    PointUncertainty* uncertainty) {
  const VariableIndex index(walk.graph, part.blocks);
  const std::vector<double> widening = WideningOfBlocks(walk, part, index);
  if (std::all_of(widening.begin(), widening.end(), [](double ratio) { return ratio <= 1.0; })) {
    return;
  }
  LinearSystem system = Linearize(walk.graph, part, index);
  BoundFirstHeading(walk, part, index, &system);
  const std::vector<bool> is_map_error = BlocksOfKind(walk, index, BlockKind::kMapError);
  WidenBlocks(widening, is_map_error, &system);
  std::optional<MarginalCovariance> marginals = MarginalCovariance::Compute(system);
  if (!marginals) return;
  marginals = UnderShownErrors(std::move(*marginals), is_map_error, map_error_test, &system);
  for (int v = 0; v < index.size(); ++v) {
    uncertainty->covariance[static_cast<std::size_t>(index.block(v))] =
        marginals->block(v).covariance;
  }
}

Mode SolveFrom(const InitialTrajectory& start, const GraphPart& part,
               const SolverSettings& settings, WalkGraph* walk, int* failed_solves) {
  SetTrajectory(start.trajectory, walk);
  // Without any absolute position the start is the answer on the plan: all that a solve could do is
  // to pull the walk's first node to the middle of the floor.
  const bool placed = walk->first_absolute_position_ns.has_value();
  if (!SolveGraduated(placed ? part : HeightPart(*walk, part), settings, &walk->graph).ok) {
    ++*failed_solves;
  }
  return {start.source,
          walk->graph.values(),
          NegativeLogDensity(walk->graph, part),
          0,
          {},
          Conditionals(*walk),
          {}};
}

void GoTo(const Mode& mode, WalkGraph* walk) {
  walk->graph.SetValues(mode.values);
  SetConditionals(mode.conditionals, walk);
}

Mode RefineOnPlaces(Mode mode, const GraphPart& part, TimeNs now_ns, const SolverSettings& settings,
                    WalkGraph* walk, int* failed_solves) {
  const auto all = [](int) { return true; };
  GoTo(mode, walk);
  ConditionNewOnPlaces(now_ns, all, all, walk);
  for (int round = 0; round < 2; ++round) {
    if (!SolveGraduated(part, settings, &walk->graph).ok) ++*failed_solves;
    ConditionNewOnPlaces(now_ns, all, all, walk);
  }
  mode.values = walk->graph.values();
  mode.conditionals = Conditionals(*walk);
  mode.negative_log_density = NegativeLogDensity(walk->graph, part);
  return mode;
}

void RankModes(const SolverSettings& settings, const GraphPart& part, WalkGraph* walk,
               std::vector<Mode>* modes) {
  std::stable_sort(modes->begin(), modes->end(), [](const Mode& a, const Mode& b) {
    return a.negative_log_density < b.negative_log_density;
  });
  std::vector<Mode> distinct;
  for (Mode& mode : *modes) {
    const auto other = std::find_if(distinct.begin(), distinct.end(), [&](const Mode& denser) {
      return SamePath(walk->graph, part, mode.values, denser.values, denser.uncertainty,
                      settings.distinct_m);
    });
    if (other != distinct.end()) {
      other->starts.insert(other->starts.end(), mode.starts.begin(), mode.starts.end());
      continue;
    }
    GoTo(mode, walk);
    mode.uncertainty = ComputeUncertainty(*walk, part, settings.map_error_test);
    mode.negative_log_mass = NegativeLogModeMass(
        mode.negative_log_density, mode.uncertainty.log_det_hessian, mode.uncertainty.variables);
    distinct.push_back(std::move(mode));
  }
  std::stable_sort(distinct.begin(), distinct.end(), [](const Mode& a, const Mode& b) {
    return a.negative_log_mass < b.negative_log_mass;
  });
  *modes = std::move(distinct);
}

std::vector<Mode> FindModes(const std::vector<InitialTrajectory>& starts, const GraphPart& part,
                            TimeNs now_ns, const SolverSettings& settings, WalkGraph* walk,
                            int* failed_solves) {
  std::vector<Mode> modes;
  SetConditionals(ConditionalsAsWalked(*walk), walk);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    modes.push_back(SolveFrom(starts[i], part, FirstSolve(settings, *walk), walk, failed_solves));
    modes.back().starts = {i};
  }
  RankModes(settings, part, walk, &modes);
  if (walk->map_errors.empty()) return modes;
  DropHopeless(settings.mode_limit_nats, &modes);
  for (Mode& mode : modes) {
    mode = RefineOnPlaces(std::move(mode), part, now_ns, settings, walk, failed_solves);
  }
  RankModes(settings, part, walk, &modes);
  return modes;
}

Trajectory MixModes(const WalkGraph& walk, const std::vector<Mode>& modes, double mode_limit_nats) {
  const std::vector<double> weights = ModeWeights(modes, KeptCount(modes, mode_limit_nats));
  Trajectory trajectory;
  double last_heading = HeadingOf(walk, modes.front().values, 0);
  for (std::size_t i = 0; i < walk.node_ns.size(); ++i) {
    PoseEstimate pose;
    pose.time_ns = walk.node_ns[i];
    pose.position_m.head<2>() = PositionOf(walk, modes.front().values, i);
    pose.position_m.z() = HeightOf(walk, modes.front().values, i);
    pose.floor = walk.floors.At(pose.time_ns);
    // A start that jumped by a turn is still a heading, but outputs are unwrapped.
    last_heading += WrapAngle(HeadingOf(walk, modes.front().values, i) - last_heading);
    pose.heading_rad = last_heading;
    pose.modes = static_cast<int>(weights.size());
    MixNode(walk, modes, weights, i, &pose);
    trajectory.poses.push_back(pose);
  }
  return trajectory;
}

std::vector<SlowStateEstimate> SlowStates(const WalkGraph& walk, const Mode& mode) {
  std::vector<SlowStateEstimate> states;
  for (std::size_t b = 0; b < walk.graph.blocks().size(); ++b) {
    const StateBlock& block = walk.graph.blocks()[b];
    if (block.constant || !IsSlowState(block.id.kind)) continue;
    const std::vector<std::string> names = CoordinateNames(block);
    for (int i = 0; i < block.size(); ++i) {
      const double sigma = std::sqrt(mode.uncertainty.covariance[b](i, i));
      const double value = mode.values[block.offset + i];
      states.push_back({names[static_cast<std::size_t>(i)], block.time_ns, value, sigma});
      if (block.id.kind == BlockKind::kBarometricOffset) {
        const double hpa = PressureAtHeight(value);
        states.push_back({"barometric_offset_hpa", block.time_ns, hpa - kSeaLevelHpa,
                          sigma * hpa / kScaleHeightM});
      }
    }
  }
  return states;
}

std::vector<Hypothesis> Hypotheses(const WalkGraph& walk, const std::vector<Mode>& modes,
                                   double mode_limit_nats) {
  const std::size_t kept = KeptCount(modes, mode_limit_nats);
  std::vector<Hypothesis> hypotheses;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    Hypothesis hypothesis{modes[m].source, modes[m].negative_log_mass, m < kept, {}};
    for (std::size_t i = 0; i < walk.node_ns.size(); ++i) {
      hypothesis.path_m.push_back(PositionOf(walk, modes[m].values, i));
    }
    hypotheses.push_back(std::move(hypothesis));
  }
  return hypotheses;
}

}  // namespace walkgraph
