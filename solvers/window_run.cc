#include "solvers/window_run.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "solvers/evidence_order.h"
#include "solvers/graph_solver.h"
#include "solvers/initial_trajectory.h"

namespace walkgraph {

WindowRun::WindowRun(const Site& site, const Evidence& evidence, const FactorSettings& factors,
                     const SolverSettings& solver, const WindowSettings& settings, int floor)
    : site_(site),
      evidence_(evidence),
      factors_(factors),
      solver_(solver),
      settings_(settings),
      walk_(BuildWalkGraph(site, evidence, factors, floor)),
      dead_reckoning_(DeadReckon(site, evidence, factors)),
      window_(&walk_.graph) {
  const FactorGraph& graph = walk_.graph;
  waiting_.resize(graph.factors().size());
  std::iota(waiting_.begin(), waiting_.end(), 0);
  std::stable_sort(waiting_.begin(), waiting_.end(), [&graph](int a, int b) {
    return graph.factor(a).arrival_ns < graph.factor(b).arrival_ns;
  });
  for (std::size_t b = 0; b < graph.blocks().size(); ++b) {
    if (IsSlowState(graph.blocks()[b].id.kind)) slow_blocks_.push_back(static_cast<int>(b));
  }
  std::stable_sort(slow_blocks_.begin(), slow_blocks_.end(), [&graph](int a, int b) {
    return graph.block(a).time_ns < graph.block(b).time_ns;
  });
  reported_.source = "window";
  reported_.values = graph.values();
  for (const StateBlock& block : graph.blocks()) {
    const int size = block.constant ? 0 : block.size();
    reported_.uncertainty.covariance.push_back(Eigen::MatrixXd::Zero(size, size));
  }
}

void WindowRun::Play() {
  for (std::size_t node = 0; node < walk_.node_ns.size(); ++node) Arrive(node);
  if (!settings_.report_newest) Report(window_.part().blocks);
}

void WindowRun::Arrive(std::size_t node) {
  const TimeNs now_ns = walk_.node_ns[node];
  PredictNode(node);
  window_.AddBlock(walk_.position[node]);
  window_.AddBlock(walk_.heading[node]);
  const bool was_located = located_;
  const bool last = node + 1 == walk_.node_ns.size();
  AddReadyFactors(now_ns, last);
  const std::size_t first_kept = FirstKeptNode(node);
  const bool first_to_leave = !marginalized_ && first_kept > 0;
  const bool starts = located_ && (!was_located || first_to_leave);
  if (starts || (last && !marginalized_)) {
    Restart(now_ns);
  } else if (located_) {
    Solve();
  }
  if (settings_.report_newest) Report({walk_.position[node], walk_.heading[node]});
  if (located_ && first_kept > oldest_) {
    const std::vector<int> leaving = LeavingBlocks(first_kept);
    if (!settings_.report_newest) Report(leaving);
    if (!window_.Marginalize(leaving)) {
      ++failed_solves_;
      return;
    }
    marginalized_ = true;
    oldest_ = first_kept;
  }
}

void WindowRun::Solve() {
  if (!SolveGraph(window_.part(), solver_, &walk_.graph).ok) {
    ++failed_solves_;
    return;
  }
  PolishSolution(window_.part(), &walk_.graph);
}

// Where the last estimate and dead reckoning lead; slow states stay as they are.
void WindowRun::PredictNode(std::size_t node) {
  FactorGraph& graph = walk_.graph;
  const TimeNs now_ns = walk_.node_ns[node];
  if (node > 0) {
    const TimeNs before_ns = walk_.node_ns[node - 1];
    const double heading = *graph.value(walk_.heading[node - 1]);
    const Eigen::Rotation2Dd turn(heading - dead_reckoning_.HeadingAt(before_ns));
    const Eigen::Vector2d moved =
        turn * (dead_reckoning_.PositionAt(now_ns) - dead_reckoning_.PositionAt(before_ns));
    const double* from = graph.value(walk_.position[node - 1]);
    double* to = graph.value(walk_.position[node]);
    to[0] = from[0] + moved.x();
    to[1] = from[1] + moved.y();
    *graph.value(walk_.heading[node]) =
        heading + dead_reckoning_.HeadingAt(now_ns) - dead_reckoning_.HeadingAt(before_ns);
  } else {
    *graph.value(walk_.heading[node]) = dead_reckoning_.HeadingAt(now_ns);
  }
  const auto later = std::find_if(slow_blocks_.begin(), slow_blocks_.end(),
                                  [&](int block) { return graph.block(block).time_ns > now_ns; });
  for (auto it = slow_blocks_.begin(); it != later; ++it) {
    window_.AddBlock(*it);
    const BlockId id = graph.block(*it).id;
    if (id.index == 0 || id.kind == BlockKind::kRssiOffset) continue;
    std::copy_n(graph.value(*it - 1), graph.block(*it).size(), graph.value(*it));
  }
  slow_blocks_.erase(slow_blocks_.begin(), later);
}

void WindowRun::AddReadyFactors(TimeNs now_ns, bool last) {
  std::vector<int> still_waiting;
  for (const int factor : waiting_) {
    const std::vector<int>& blocks = walk_.graph.factor(factor).blocks;
    const bool arrived = last || walk_.graph.factor(factor).arrival_ns <= now_ns;
    const bool complete = std::all_of(blocks.begin(), blocks.end(), [this](int block) {
      return walk_.graph.block(block).constant || window_.IsActive(block) || window_.HasLeft(block);
    });
    if (!arrived || !complete) {
      still_waiting.push_back(factor);
    } else if (!window_.AddFactor(factor)) {
      ++dropped_late_;
    } else if (walk_.graph.factor(factor).absolute_position) {
      located_ = true;
    }
  }
  waiting_ = std::move(still_waiting);
}

// Starts anew from what the window's own evidence proposes. Only while nothing has left it.
void WindowRun::Restart(TimeNs now_ns) {
  const Evidence seen = EvidenceUntil(evidence_, now_ns);
  std::vector<Mode> modes;
  for (const InitialTrajectory& start :
       ProposeTrajectories(site_, seen, factors_, solver_, walk_.floor)) {
    modes.push_back(SolveFrom(start, window_.part(), solver_, &walk_, &failed_solves_));
  }
  RankModes(solver_, window_.part(), &walk_, &modes);
  walk_.graph.SetValues(modes.front().values);
}

// The first node that stays once `newest` has come.
std::size_t WindowRun::FirstKeptNode(std::size_t newest) const {
  if (settings_.nodes > 0) {
    const auto kept = static_cast<std::size_t>(settings_.nodes);
    return newest + 1 > kept ? newest + 1 - kept : 0;
  }
  const TimeNs oldest_ns = walk_.node_ns[newest] - DurationNs(settings_.seconds);
  return static_cast<std::size_t>(
      std::lower_bound(walk_.node_ns.begin(), walk_.node_ns.begin() + newest, oldest_ns) -
      walk_.node_ns.begin());
}

// Nodes before the first kept one, and knots that a later one has replaced by its time.
std::vector<int> WindowRun::LeavingBlocks(std::size_t first_kept) const {
  std::vector<int> leaving;
  for (std::size_t node = oldest_; node < first_kept; ++node) {
    leaving.push_back(walk_.position[node]);
    leaving.push_back(walk_.heading[node]);
  }
  for (const int block : window_.part().blocks) {
    const StateBlock& state = walk_.graph.block(block);
    if (!IsSlowState(state.id.kind) || state.id.kind == BlockKind::kRssiOffset) continue;
    const auto next = static_cast<std::size_t>(block) + 1;  // knots of a state are added in a row
    if (next == walk_.graph.blocks().size()) continue;
    const StateBlock& successor = walk_.graph.blocks()[next];
    if (successor.id.kind == state.id.kind && successor.time_ns <= walk_.node_ns[first_kept]) {
      leaving.push_back(block);
    }
  }
  return leaving;
}

void WindowRun::Report(const std::vector<int>& blocks) {
  const PointUncertainty uncertainty = ComputeUncertainty(walk_, window_.part());
  for (const int block : blocks) {
    const StateBlock& state = walk_.graph.block(block);
    reported_.values.segment(state.offset, state.size()) =
        walk_.graph.values().segment(state.offset, state.size());
    if (state.constant) continue;
    reported_.uncertainty.covariance[static_cast<std::size_t>(block)] =
        uncertainty.covariance[static_cast<std::size_t>(block)];
  }
}

}  // namespace walkgraph
