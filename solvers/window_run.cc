#include "solvers/window_run.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "graph/graph_part.h"
#include "graph/innovations.h"
#include "graph/map_error_states.h"
#include "solvers/graph_solver.h"

namespace walkgraph {

WindowRun::WindowRun(const Site& site, const Evidence& evidence, const FactorSettings& factors,
                     const SolverSettings& solver, const WindowSettings& settings,
                     const FloorPath& floors)
    : site_(site),
      evidence_(evidence),
      factors_(factors),
      solver_(solver),
      settings_(settings),
      walk_(BuildWalkGraph(site, evidence, factors, floors)),
      dead_reckoning_(DeadReckon(site, evidence, factors)) {
  const FactorGraph& graph = walk_.graph;
  hypotheses_.push_back({SlidingWindow(&walk_.graph), graph.values(), Conditionals(walk_), {}});
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
  reported_.conditionals = hypotheses_.front().conditionals;
  if (settings_.report_newest) return;
  Weigh();
  Report(window().part().blocks);
}

void WindowRun::Arrive(std::size_t node) {
  const TimeNs now_ns = walk_.node_ns[node];
  const std::vector<int> slow_blocks = TakeSlowBlocks(now_ns);
  for (WindowHypothesis& hypothesis : hypotheses_) {
    GoTo(hypothesis, &walk_);
    PredictNode(node, slow_blocks);
    hypothesis.values = walk_.graph.values();
    for (const int block : slow_blocks) hypothesis.window.AddBlock(block);
    for (const int block : NodeBlocks(walk_, node)) hypothesis.window.AddBlock(block);
    ConditionMapErrors(now_ns, slow_blocks, &hypothesis);
  }
  const bool last = node + 1 == walk_.node_ns.size();
  const std::vector<int> joined = AddReadyFactors(now_ns, last);
  if (settings_.innovations && marginalized_) JudgeReadings(joined);
  const std::size_t first_kept = FirstKeptNode(node);
  const bool full = first_kept > 0;
  if (!marginalized_ && (last || (has_evidence_ && StartIsDue(now_ns, full)))) {
    Restart(node, full || last);
  } else if (started_ns_) {
    for (WindowHypothesis& hypothesis : hypotheses_) Solve(&hypothesis);
  }
  if (marginalized_ && CheckIsDue(node)) CheckTracks(node);
  if (full && has_evidence_ && !located_) {
    located_ = IsLocated();
    if (!full_ns_) full_ns_ = now_ns;
    waited_s_ = SecondsBetween(*full_ns_, now_ns);
  }
  const bool leaves = located_ && first_kept > oldest_;
  if (settings_.report_newest || leaves) Weigh();
  if (settings_.report_newest) Report(NodeBlocks(walk_, node));
  if (leaves) Marginalize(first_kept);
}

void WindowRun::Marginalize(std::size_t first_kept) {
  const std::vector<int> leaving = LeavingBlocks(first_kept);
  if (!settings_.report_newest) Report(leaving);
  std::vector<WindowHypothesis> kept;
  for (WindowHypothesis& hypothesis : hypotheses_) {
    GoTo(hypothesis, &walk_);
    if (hypothesis.window.Marginalize(leaving)) {
      kept.push_back(std::move(hypothesis));
    } else {
      ++failed_solves_;
    }
  }
  // Where none can, all stay as they are and the next arrival tries again.
  if (kept.empty()) return;
  hypotheses_ = std::move(kept);
  marginalized_ = true;
  oldest_ = first_kept;
}

void WindowRun::Solve(WindowHypothesis* hypothesis) {
  GoTo(*hypothesis, &walk_);
  if (!SolveGraph(hypothesis->window.part(), solver_, &walk_.graph).ok) {
    ++failed_solves_;
    return;
  }
  PolishSolution(hypothesis->window.part(), &walk_.graph);
  hypothesis->values = walk_.graph.values();
}

// Slow states whose time has come.
std::vector<int> WindowRun::TakeSlowBlocks(TimeNs now_ns) {
  const auto later = std::find_if(slow_blocks_.begin(), slow_blocks_.end(), [&](int block) {
    return walk_.graph.block(block).time_ns > now_ns;
  });
  std::vector<int> taken(slow_blocks_.begin(), later);
  slow_blocks_.erase(slow_blocks_.begin(), later);
  return taken;
}

// Where the last estimate and dead reckoning lead; slow states stay as they are.
void WindowRun::PredictNode(std::size_t node, const std::vector<int>& new_slow_blocks) {
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
  for (const int block : new_slow_blocks) {
    const BlockId id = graph.block(block).id;
    if (id.index == 0 || id.kind == BlockKind::kRssiOffset) continue;
    std::copy_n(graph.value(block - 1), graph.block(block).size(), graph.value(block));
  }
}

// The errors of maps among `blocks`, given earlier ones that the window has, by where the
// hypothesis, at whose values the graph is, passed them.
void WindowRun::ConditionMapErrors(TimeNs now_ns, const std::vector<int>& blocks,
                                   WindowHypothesis* hypothesis) {
  if (blocks.empty()) return;
  const auto is_new = [&blocks](int block) {
    return std::find(blocks.begin(), blocks.end(), block) != blocks.end();
  };
  const SlidingWindow& window = hypothesis->window;
  ConditionNewOnPlaces(
      now_ns, is_new, [&window](int block) { return window.IsActive(block); }, &walk_);
  hypothesis->conditionals = Conditionals(walk_);
}

// Returns those that now take part.
std::vector<int> WindowRun::AddReadyFactors(TimeNs now_ns, bool last) {
  std::vector<int> joined, still_waiting;
  for (const int factor : waiting_) {
    const std::vector<int>& blocks = walk_.graph.factor(factor).blocks;
    const bool arrived = last || walk_.graph.factor(factor).arrival_ns <= now_ns;
    const bool complete = std::all_of(blocks.begin(), blocks.end(), [this](int block) {
      return walk_.graph.block(block).constant || window().IsActive(block) ||
             window().HasLeft(block);
    });
    if (!arrived || !complete) {
      still_waiting.push_back(factor);
      continue;
    }
    bool used = true;  // the same in all: they have the same blocks
    for (WindowHypothesis& hypothesis : hypotheses_) used = hypothesis.window.AddFactor(factor);
    if (!used) {
      ++dropped_late_;
      continue;
    }
    joined.push_back(factor);
    if (walk_.graph.factor(factor).absolute_position) has_evidence_ = true;
  }
  waiting_ = std::move(still_waiting);
  return joined;
}

// The innovations of the readings among the factors that just joined, by the best hypothesis:
// against the minimum of everything else that the window holds.
void WindowRun::JudgeReadings(const std::vector<int>& joined) {
  std::vector<int> readings;
  std::copy_if(joined.begin(), joined.end(), std::back_inserter(readings),
               [this](int factor) { return walk_.graph.factor(factor).reading; });
  if (readings.empty()) return;
  GraphPart expected = window().part();
  std::erase_if(expected.factors, [&readings](int factor) {
    return std::find(readings.begin(), readings.end(), factor) != readings.end();
  });
  GoTo(hypotheses_.front(), &walk_);
  if (!SolveGraph(expected, solver_, &walk_.graph).ok) return;
  const std::vector<FactorFit> found = ComputeInnovations(walk_.graph, expected, readings);
  innovations_.insert(innovations_.end(), found.begin(), found.end());
}

void WindowRun::Weigh() {
  WeighHypotheses(solver_, settings_.hypothesis_nats, &walk_, &hypotheses_);
  if (hypotheses_.front().taken_up) ++recoveries_;
  hypotheses_.front().taken_up = false;
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

// Nodes before the first kept one, and knots that a later one has replaced by its time; errors of
// maps some time later.
std::vector<int> WindowRun::LeavingBlocks(std::size_t first_kept) const {
  std::vector<int> leaving;
  for (std::size_t node = oldest_; node < first_kept; ++node) {
    const std::vector<int> blocks = NodeBlocks(walk_, node);
    leaving.insert(leaving.end(), blocks.begin(), blocks.end());
  }
  for (const int block : window().part().blocks) {
    const StateBlock& state = walk_.graph.block(block);
    if (!IsSlowState(state.id.kind) || state.id.kind == BlockKind::kRssiOffset) continue;
    const auto next = static_cast<std::size_t>(block) + 1;  // knots of a state are added in a row
    if (next == walk_.graph.blocks().size()) continue;
    const StateBlock& successor = walk_.graph.blocks()[next];
    const bool of_map =
        state.id.kind == BlockKind::kMapError || state.id.kind == BlockKind::kMagneticError;
    const TimeNs kept_ns =
        walk_.node_ns[first_kept] - (of_map ? DurationNs(settings_.map_error_s) : 0);
    if (successor.id.kind == state.id.kind && successor.time_ns <= kept_ns) {
      leaving.push_back(block);
    }
  }
  return leaving;
}

// The best hypothesis's values, with the covariance of the mixture of all about them.
void WindowRun::Report(const std::vector<int>& blocks) {
  for (WindowHypothesis& hypothesis : hypotheses_) {  // until they are weighed again
    GoTo(hypothesis, &walk_);
    WidenOffSurvey(walk_, hypothesis.window.part(), solver_.map_error_test,
                   &hypothesis.uncertainty);
  }
  for (const int block : blocks) {
    const StateBlock& state = walk_.graph.block(block);
    reported_.values.segment(state.offset, state.size()) =
        hypotheses_.front().values.segment(state.offset, state.size());
    if (state.constant) continue;
    reported_.uncertainty.covariance[static_cast<std::size_t>(block)] =
        MixtureCovariance(walk_.graph, hypotheses_, block);
  }
}

}  // namespace walkgraph
