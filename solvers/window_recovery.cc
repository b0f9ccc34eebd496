#include "solvers/window_recovery.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "graph/graph_part.h"

namespace walkgraph {
namespace {

// The stretch's block that says at `time_ns` what a window's block says: of a node or knot the
// last one until then. -1 where the stretch has none.
int Counterpart(const FactorGraph& graph, const BlockId& id, TimeNs time_ns) {
  int counterpart = -1;
  for (std::size_t b = 0; b < graph.blocks().size(); ++b) {
    const StateBlock& block = graph.blocks()[b];
    if (block.constant || block.id.kind != id.kind) continue;
    if (id.kind == BlockKind::kRssiOffset && block.id.index != id.index) continue;
    if (counterpart < 0 || block.time_ns <= time_ns) counterpart = static_cast<int>(b);
  }
  return counterpart;
}

// Whether a track goes by a mode's path since a time.
bool GoesBy(const Mode& mode, const Trajectory& track, TimeNs since_ns,
            const SolverSettings& solver, WalkGraph* walk) {
  SetTrajectory(track, walk);
  GraphPart recent;
  for (std::size_t node = 0; node < walk->node_ns.size(); ++node) {
    if (walk->node_ns[node] >= since_ns) recent.blocks.push_back(walk->position[node]);
  }
  return SamePath(walk->graph, recent, walk->graph.values(), mode.values, mode.uncertainty,
                  solver.distinct_m);
}

}  // namespace

std::vector<InitialTrajectory> TracksAndProposals(const std::vector<Trajectory>& tracks,
                                                  const Site& site, const Evidence& evidence,
                                                  const FactorSettings& factors,
                                                  const FloorPath& floors, int placements) {
  std::vector<InitialTrajectory> starts;
  for (const Trajectory& track : tracks) starts.push_back({"track", track});
  std::vector<InitialTrajectory> proposals =
      ProposeTrajectories(site, evidence, factors, floors, placements);
  std::move(proposals.begin(), proposals.end(), std::back_inserter(starts));
  return starts;
}

std::optional<Stretch> SmoothStretch(const Site& site, const Evidence& recent,
                                     const FactorSettings& factors, const SolverSettings& solver,
                                     const std::vector<Trajectory>& tracks, TimeNs window_begin_ns,
                                     const FloorPath& floors) {
  Stretch stretch{BuildWalkGraph(site, recent, factors, floors), {}, {}};
  WalkGraph& walk = stretch.walk;
  if (!walk.first_absolute_position_ns) return std::nullopt;
  const std::vector<InitialTrajectory> starts =
      TracksAndProposals(tracks, site, recent, factors, floors, /*placements=*/0);
  int failed_solves = 0;
  stretch.modes =
      FindModes(starts, WholeGraph(walk.graph), walk.node_ns.back(), solver, &walk, &failed_solves);
  stretch.tracks.resize(tracks.size());
  for (std::size_t m = 0; m < stretch.modes.size(); ++m) {
    for (const std::size_t start : stretch.modes[m].starts) {
      if (start >= tracks.size()) continue;
      stretch.tracks[start] = {static_cast<int>(m), GoesBy(stretch.modes[m], tracks[start],
                                                           window_begin_ns, solver, &walk)};
    }
  }
  return stretch;
}

void MoveTo(const WalkGraph& stretch, const Mode& mode, const FactorGraph& graph,
            const std::vector<int>& blocks, Eigen::VectorXd* values) {
  const Trajectory trajectory = MixModes(stretch, {mode}, 0);
  for (const int b : blocks) {
    const StateBlock& block = graph.block(b);
    if (block.constant) continue;
    auto value = values->segment(block.offset, block.size());
    if (block.id.kind == BlockKind::kPosition) {
      value = trajectory.At(block.time_ns).position_m.head<2>();
    } else if (block.id.kind == BlockKind::kHeading) {
      value[0] = trajectory.At(block.time_ns).heading_rad;
    } else if (block.id.kind == BlockKind::kHeight) {
      value[0] = trajectory.At(block.time_ns).position_m.z();
    } else if (const int other = Counterpart(stretch.graph, block.id, block.time_ns); other >= 0) {
      value = mode.values.segment(stretch.graph.block(other).offset, block.size());
    }
  }
}

LinearPrior PriorFrom(const WalkGraph& stretch, const Mode& mode, const FactorGraph& graph,
                      const std::vector<int>& blocks, const Eigen::VectorXd& values) {
  LinearPrior prior;
  std::vector<double> information;  // square root, by row
  std::vector<double> point;
  std::set<std::pair<BlockKind, int>> seen;
  TimeNs first_node_ns = std::numeric_limits<TimeNs>::max();
  for (const int b : blocks) {
    const StateBlock& block = graph.block(b);
    if (block.id.kind == BlockKind::kPosition) {
      first_node_ns = std::min(first_node_ns, block.time_ns);
    }
  }
  for (const int b : blocks) {
    const StateBlock& block = graph.block(b);
    const int radio = block.id.kind == BlockKind::kRssiOffset ? block.id.index : 0;
    const bool first = seen.insert({block.id.kind, radio}).second;
    if (block.constant || !(first || block.time_ns < first_node_ns)) continue;
    const int other = Counterpart(stretch.graph, block.id, block.time_ns);
    if (other < 0) continue;
    const Eigen::MatrixXd& covariance =
        mode.uncertainty.covariance[static_cast<std::size_t>(other)];
    const double sigma = std::sqrt(covariance.diagonal().maxCoeff());
    if (!std::isfinite(sigma) || sigma <= 0) continue;
    prior.blocks.push_back(b);
    for (int i = 0; i < block.size(); ++i) {
      information.push_back(1.0 / (2.0 * sigma));
      point.push_back(values[block.offset + i]);
    }
  }
  const auto rows = static_cast<Eigen::Index>(information.size());
  prior.jacobian = Eigen::VectorXd::Map(information.data(), rows).asDiagonal();
  prior.residual = Eigen::VectorXd::Zero(rows);
  prior.point = Eigen::VectorXd::Map(point.data(), rows);
  return prior;
}

}  // namespace walkgraph
