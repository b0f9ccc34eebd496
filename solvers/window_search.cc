#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "solvers/evidence_order.h"
#include "solvers/window_run.h"

// How a WindowRun comes by the hypotheses that it follows: from starts while nothing has left the
// window, then from the whole-walk smoother on what was seen lately.

namespace walkgraph {

// Proposals are made just before the first node would leave (the window is full), and from then on
// whenever the window has grown by half, until the walk is located. Where poses are reported at
// once, with the first evidence of a place, too.
bool WindowRun::StartIsDue(TimeNs now_ns, bool full) const {
  if (!full) return settings_.report_newest && !started_ns_;
  const TimeNs begin_ns = walk_.node_ns.front();
  return !started_full_ || now_ns - begin_ns >= (*started_ns_ - begin_ns) * 3 / 2;
}

// Starts anew from what the window's own evidence proposes, and from what it follows. Only while
// nothing has left it. Every mode worth following becomes a hypothesis once the window is full,
// before that the best alone.
void WindowRun::Restart(std::size_t node, bool full) {
  const TimeNs now_ns = walk_.node_ns[node];
  const SlidingWindow start_window = window();
  const std::vector<Trajectory> tracks =
      started_full_ ? Tracks(walk_.node_ns.front(), node) : std::vector<Trajectory>{};
  std::vector<Mode> modes = FindModes(
      TracksAndProposals(tracks, site_, Seen(node), factors_, walk_.floors, solver_.hypotheses),
      start_window.part(), now_ns, solver_, &walk_, &failed_solves_);
  started_ns_ = now_ns;
  started_full_ = full;
  const int most = full ? std::max(1, settings_.hypotheses) : 1;
  hypotheses_.clear();
  for (Mode& mode : modes) {
    if (static_cast<int>(hypotheses_.size()) == most) break;
    if (!hypotheses_.empty() &&
        !(mode.negative_log_mass <= modes.front().negative_log_mass + settings_.hypothesis_nats)) {
      break;
    }
    hypotheses_.push_back({start_window, std::move(mode.values), std::move(mode.conditionals),
                           std::move(mode.uncertainty), mode.negative_log_mass});
  }
}

// Whether the oldest node, the first to leave, is known: to the configured sigma, and with less
// between the hypotheses than within the best.
bool WindowRun::IsLocated() {
  Weigh();
  const int position = walk_.position[oldest_];
  const double variance = MixtureCovariance(walk_.graph, hypotheses_, position).trace();
  const double within =
      hypotheses_.front().uncertainty.covariance[static_cast<std::size_t>(position)].trace();
  return variance < settings_.located_sigma_m * settings_.located_sigma_m && variance < 2 * within;
}

// Once every window length, and with the last node.
bool WindowRun::CheckIsDue(std::size_t node) const {
  const TimeNs length_ns = walk_.node_ns[node] - walk_.node_ns[oldest_];
  if (length_ns <= 0) return false;  // a window of one node has no way to compare
  const bool last = node + 1 == walk_.node_ns.size();
  return last || walk_.node_ns[node] - checked_ns_.value_or(*started_ns_) >= length_ns;
}

// What the window follows is held against what the whole-walk smoother makes of the last window
// lengths: it sees the whole floor, and nothing there is linearised once for all.
void WindowRun::CheckTracks(std::size_t node) {
  constexpr int kCheckedLengths = 6;  // a minute of a window of ten seconds
  const TimeNs now_ns = walk_.node_ns[node];
  const TimeNs since_ns = now_ns - kCheckedLengths * (now_ns - walk_.node_ns[oldest_]);
  checked_ns_ = now_ns;
  Weigh();
  const std::optional<Stretch> stretch =
      SmoothStretch(site_, EvidenceSince(Seen(node), since_ns), factors_, solver_,
                    Tracks(since_ns, node), walk_.node_ns[oldest_], walk_.floors);
  if (!stretch) return;
  // What speaks for the tracks from before that is not known, but bounded: other hypotheses were
  // dropped when they were this much worse.
  const double margin_nats = since_ns <= walk_.node_ns.front() ? 0.0 : settings_.hypothesis_nats;
  TakeUpOthers(*stretch, margin_nats, node);
}

// The modes of a stretch by which no hypothesis goes become hypotheses, weighed against the best
// that goes by one; they take the place of those that only lead to them, which stand on what was
// marginalised elsewhere. Where none goes by any they take the place of all.
void WindowRun::TakeUpOthers(const Stretch& stretch, double margin_nats, std::size_t newest) {
  const std::vector<TrackPlace>& tracks = stretch.tracks;
  const auto held =
      std::find_if(tracks.begin(), tracks.end(), [](const TrackPlace& track) { return track.at; });
  const double limit = hypotheses_.front().negative_log_mass + settings_.hypothesis_nats;
  double beyond_stretch = 0;  // what the hypotheses' masses hold besides
  if (held != tracks.end()) {
    beyond_stretch =
        hypotheses_[static_cast<std::size_t>(held - tracks.begin())].negative_log_mass -
        stretch.modes[static_cast<std::size_t>(held->mode)].negative_log_mass;
  }
  std::vector<WindowHypothesis> next;
  for (std::size_t m = 0; m < stretch.modes.size(); ++m) {
    const auto leads_here = [m](const TrackPlace& track) {
      return track.mode == static_cast<int>(m);
    };
    const auto goes_by = [&](const TrackPlace& track) { return leads_here(track) && track.at; };
    if (std::any_of(tracks.begin(), tracks.end(), goes_by)) continue;
    const bool known = std::any_of(tracks.begin(), tracks.end(), leads_here);
    const double mass =
        stretch.modes[m].negative_log_mass + beyond_stretch + (known ? 0.0 : margin_nats);
    if (held == tracks.end() || mass <= limit) {
      next.push_back(TakeUp(stretch, stretch.modes[m], newest, mass));
    }
  }
  for (std::size_t h = 0; h < hypotheses_.size(); ++h) {
    const bool stays = tracks[h].at || (held != tracks.end() && tracks[h].mode < 0);
    if (stays) next.push_back(std::move(hypotheses_[h]));
  }
  hypotheses_ = std::move(next);
  Weigh();
  const auto most = static_cast<std::ptrdiff_t>(std::max(1, settings_.hypotheses));
  if (std::ssize(hypotheses_) > most) {
    hypotheses_.erase(hypotheses_.begin() + most, hypotheses_.end());
  }
}

// The window moved to a mode of what was seen lately: its evidence stays, what left it is
// forgotten.
WindowHypothesis WindowRun::TakeUp(const Stretch& stretch, const Mode& mode, std::size_t newest,
                                   double negative_log_mass) {
  WindowHypothesis fresh = hypotheses_.front();
  const std::vector<int>& blocks = fresh.window.part().blocks;
  // Nodes that have left, too: they say where the maps' errors were.
  MoveTo(stretch.walk, mode, walk_.graph, LeftNodeBlocks(stretch.walk.node_ns.front()),
         &fresh.values);
  MoveTo(stretch.walk, mode, walk_.graph, blocks, &fresh.values);
  GoTo(fresh, &walk_);
  ConditionMapErrors(walk_.node_ns[newest], blocks, &fresh);
  fresh.window.ReplacePriors(PriorFrom(stretch.walk, mode, walk_.graph, blocks, fresh.values));
  fresh.taken_up = true;
  Solve(&fresh);
  std::vector<WindowHypothesis> alone{std::move(fresh)};
  WeighHypotheses(solver_, settings_.hypothesis_nats, &walk_, &alone);
  const double forgotten_nats = negative_log_mass - alone.front().negative_log_mass;
  if (std::isfinite(forgotten_nats)) alone.front().forgotten_nats += forgotten_nats;
  return std::move(alone.front());
}

// Of the nodes since a time that have left the window.
std::vector<int> WindowRun::LeftNodeBlocks(TimeNs since_ns) const {
  std::vector<int> blocks;
  for (std::size_t node = 0; node < oldest_; ++node) {
    if (walk_.node_ns[node] < since_ns) continue;
    const std::vector<int> own = NodeBlocks(walk_, node);
    blocks.insert(blocks.end(), own.begin(), own.end());
  }
  return blocks;
}

// Where the walk went since a time by each hypothesis: as reported, and as it has the nodes in the
// window.
std::vector<Trajectory> WindowRun::Tracks(TimeNs since_ns, std::size_t newest) const {
  std::vector<Trajectory> tracks;
  for (const WindowHypothesis& hypothesis : hypotheses_) {
    Trajectory& track = tracks.emplace_back();
    for (std::size_t node = 0; node <= newest; ++node) {
      if (walk_.node_ns[node] < since_ns) continue;
      const Eigen::VectorXd& values = node < oldest_ ? reported_.values : hypothesis.values;
      PoseEstimate pose;
      pose.time_ns = walk_.node_ns[node];
      pose.floor = walk_.floors.At(pose.time_ns);
      pose.position_m.head<2>() = values.segment<2>(walk_.graph.block(walk_.position[node]).offset);
      pose.heading_rad = values[walk_.graph.block(walk_.heading[node]).offset];
      track.poses.push_back(pose);
    }
  }
  return tracks;
}

// What was there to be used when a node came; with the last one all is.
Evidence WindowRun::Seen(std::size_t newest) const {
  const bool last = newest + 1 == walk_.node_ns.size();
  return last ? evidence_ : EvidenceUntil(evidence_, walk_.node_ns[newest]);
}

}  // namespace walkgraph
