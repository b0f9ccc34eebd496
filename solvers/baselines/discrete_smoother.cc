#include "solvers/baselines/discrete_smoother.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "data/angle.h"
#include "factors/map_sweeps.h"
#include "solvers/baselines/discrete_motion.h"
#include "solvers/baselines/lattice.h"
#include "solvers/baselines/likelihood_grid.h"

namespace walkgraph {
namespace {

// Readings of a sweep closer in time than this are placed together: 0.3 m of walking.
constexpr double kPartSeconds = 0.5;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::vector<TimeNs> EpochTimes(const Evidence& evidence, double epoch_s) {
  const double span_s = SecondsBetween(evidence.begin_ns, evidence.end_ns);
  const int intervals = std::max(1, static_cast<int>(std::lround(span_s / epoch_s)));
  std::vector<TimeNs> times;
  for (int i = 0; i <= intervals; ++i) {
    times.push_back(evidence.begin_ns + DurationNs(span_s * i / intervals));
  }
  return times;
}

std::size_t NearestEpoch(const std::vector<TimeNs>& times, TimeNs time_ns) {
  const auto after = std::lower_bound(times.begin(), times.end(), time_ns);
  if (after == times.begin()) return 0;
  if (after == times.end()) return times.size() - 1;
  const auto i = static_cast<std::size_t>(after - times.begin());
  return time_ns - times[i - 1] < times[i] - time_ns ? i - 1 : i;
}

// -log p of all absolute evidence near each epoch, for every cell.
class Emissions {
 public:
  Emissions(const Lattice& lattice, const DeadReckonedPath& walk, std::vector<TimeNs> times)
      : lattice_(lattice),
        walk_(walk),
        times_(std::move(times)),
        nats_(times_.size(), std::vector<float>(lattice.size(), 0.0F)) {}

  void AddSweeps(const Site& site, const RadioMap& map, const Evidence& evidence,
                 const FactorSettings& settings, const FloorPath& floors) {
    const std::vector<MapSweep> sweeps =
        CollectMapSweeps(site, map, evidence, settings.fingerprint, floors, kPartSeconds);
    if (sweeps.empty()) return;
    const LikelihoodGrid grid(map, lattice_.centers_m(), settings.rssi_offset.SpreadDb(),
                              settings.fingerprint.loss);
    const std::vector<std::vector<float>> costs = grid.Evaluate(sweeps);
    for (std::size_t s = 0; s < sweeps.size(); ++s) AddMoved(sweeps[s].mean_heard_ns, costs[s]);
    any_ = true;
  }

  void AddAnchor(const PositionAnchor& anchor) {
    const std::size_t epoch = NearestEpoch(times_, anchor.time_ns);
    const Eigen::Vector2d at = anchor.position_m - MovedSince(epoch, anchor.time_ns);
    const double variance = anchor.sigma_m * anchor.sigma_m + QuantisationVariance();
    for (std::size_t c = 0; c < lattice_.size(); ++c) {
      const double squared = (lattice_.centers_m()[c] - at).squaredNorm();
      nats_[epoch][c] += static_cast<float>(0.5 * squared / variance);
    }
    any_ = true;
  }

  double QuantisationVariance() const { return lattice_.spacing_m() * lattice_.spacing_m() / 12.0; }
  bool any() const { return any_; }
  const std::vector<TimeNs>& times() const { return times_; }
  const std::vector<float>& at(std::size_t epoch) const { return nats_[epoch]; }

 private:
  // Unknown without an absolute heading, which alone tells the direction of the dead reckoning: the
  // mean over all directions is zero.
  Eigen::Vector2d MovedSince(std::size_t epoch, TimeNs time_ns) const {
    if (walk_.source != HeadingSource::kAbsolute) return Eigen::Vector2d::Zero();
    return walk_.PositionAt(time_ns) - walk_.PositionAt(times_[epoch]);
  }

  // A reading heard between epochs speaks of the cell that the person passed then.
  void AddMoved(TimeNs time_ns, const std::vector<float>& cost) {
    const std::size_t epoch = NearestEpoch(times_, time_ns);
    const Eigen::Vector2d moved = MovedSince(epoch, time_ns) / lattice_.spacing_m();
    const int columns = static_cast<int>(std::lround(moved.x()));
    const int rows = static_cast<int>(std::lround(moved.y()));
    std::vector<float>& sum = nats_[epoch];
    for (std::size_t c = 0; c < sum.size(); ++c) {
      const std::int32_t passed = lattice_.Neighbour(static_cast<std::int32_t>(c), columns, rows);
      // Off the lattice the nearest thing known is the cell itself.
      sum[c] += cost[passed == Lattice::kNoCell ? c : static_cast<std::size_t>(passed)];
    }
  }

  const Lattice& lattice_;
  const DeadReckonedPath& walk_;
  std::vector<TimeNs> times_;
  std::vector<std::vector<float>> nats_;
  bool any_ = false;
};

struct State {
  std::int32_t cell = 0;
  std::int32_t bin = 0;
  std::int32_t previous = -1;  // index into the states of the epoch before
  float nats = 0;
};
using Layer = std::vector<State>;

class Trellis {
 public:
  Trellis(const Lattice& lattice, const HeadingBins& bins, double beam_nats)
      : lattice_(lattice),
        bins_(bins),
        beam_nats_(static_cast<float>(beam_nats)),
        slot_(lattice.size() * bins.offset_rad.size(), -1) {}

  void Begin(const std::vector<float>& emission) {
    Layer layer;
    for (int bin = 0; bin < bins_.size(); ++bin) {
      for (std::size_t c = 0; c < lattice_.size(); ++c) {
        layer.push_back({static_cast<std::int32_t>(c), bin, -1,
                         emission[c] + bins_.prior_nats[static_cast<std::size_t>(bin)]});
      }
    }
    layers_.push_back(Prune(std::move(layer)));
  }

  void Advance(const Transition& transition, const std::vector<float>& emission) {
    const Layer& from = layers_.back();
    Layer to;
    limit_nats_ = LimitOf(from, transition, emission) + beam_nats_;
    for (int bin = 0; bin < bins_.size(); ++bin) {
      const double turn = bins_.offset_rad[static_cast<std::size_t>(bin)];
      const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(turn).toRotationMatrix();
      PrepareMoves(rotation * transition.displacement_m, transition.variance_m2);
      for (std::size_t i = 0; i < from.size(); ++i) {
        if (from[i].bin == bin) Spread(from, static_cast<std::int32_t>(i), emission, &to);
      }
    }
    for (const State& state : to) slot_[Slot(state)] = -1;
    // A walk that leaves the lattice stays where it was rather than losing every state.
    layers_.push_back(to.empty() ? Stay(from) : Prune(std::move(to)));
  }

  const std::vector<Layer>& layers() const { return layers_; }

 private:
  struct Move {
    int columns, rows;
    float nats;
  };

  std::size_t Slot(const State& state) const {
    return static_cast<std::size_t>(state.bin) * lattice_.size() +
           static_cast<std::size_t>(state.cell);
  }

  Layer Prune(Layer layer) const {
    float best = kInfinity;
    for (const State& state : layer) best = std::min(best, state.nats);
    std::erase_if(layer, [&](const State& state) { return !(state.nats <= best + beam_nats_); });
    return layer;
  }

  static Layer Stay(const Layer& from) {
    Layer layer = from;
    for (std::size_t i = 0; i < layer.size(); ++i) {
      layer[i].previous = static_cast<std::int32_t>(i);
    }
    return layer;
  }

  void PrepareMoves(const Eigen::Vector2d& displacement_m, double variance_m2) {
    moves_.clear();
    const double h = lattice_.spacing_m();
    const Eigen::Vector2d mean = displacement_m / h;
    const int reach = static_cast<int>(std::ceil(3.0 * std::sqrt(variance_m2) / h));
    const int column = static_cast<int>(std::lround(mean.x()));
    const int row = static_cast<int>(std::lround(mean.y()));
    const double normaliser = std::log(2.0 * std::numbers::pi * variance_m2);
    for (int r = row - reach; r <= row + reach; ++r) {
      for (int c = column - reach; c <= column + reach; ++c) {
        const double squared = (Eigen::Vector2d(c, r) - mean).squaredNorm() * h * h;
        moves_.push_back({c, r, static_cast<float>(0.5 * squared / variance_m2 + normaliser)});
      }
    }
  }

  // What the best state reaches: the next layer's best is no worse, so that whatever lies a beam
  // above it need not be kept at all. Infinite where that state has left the lattice.
  float LimitOf(const Layer& from, const Transition& transition,
                const std::vector<float>& emission) {
    const auto best = std::min_element(
        from.begin(), from.end(), [](const State& a, const State& b) { return a.nats < b.nats; });
    const double turn = bins_.offset_rad[static_cast<std::size_t>(best->bin)];
    PrepareMoves(Eigen::Rotation2Dd(turn) * transition.displacement_m, transition.variance_m2);
    float limit = kInfinity;
    for (const Move& move : moves_) {
      const std::int32_t cell = lattice_.Neighbour(best->cell, move.columns, move.rows);
      if (cell == Lattice::kNoCell) continue;
      limit = std::min(limit, best->nats + move.nats + emission[static_cast<std::size_t>(cell)]);
    }
    return limit;
  }

  void Spread(const Layer& from, std::int32_t index, const std::vector<float>& emission,
              Layer* to) {
    const State& state = from[static_cast<std::size_t>(index)];
    for (const Move& move : moves_) {
      const std::int32_t cell = lattice_.Neighbour(state.cell, move.columns, move.rows);
      if (cell == Lattice::kNoCell) continue;
      const float nats = state.nats + move.nats + emission[static_cast<std::size_t>(cell)];
      if (nats > limit_nats_) continue;
      for (int step = -1; step <= 1; ++step) {
        const int bin = bins_.size() == 1 ? (step == 0 ? 0 : -1) : bins_.Neighbour(state.bin, step);
        if (bin < 0) continue;
        const float change = step == 0 ? 0.0F : bins_.change_nats;
        Relax({cell, bin, index, nats + change}, to);
      }
    }
  }

  void Relax(const State& candidate, Layer* to) {
    std::int32_t& slot = slot_[Slot(candidate)];
    if (slot < 0) {
      slot = static_cast<std::int32_t>(to->size());
      to->push_back(candidate);
    } else if (candidate.nats < (*to)[static_cast<std::size_t>(slot)].nats) {
      (*to)[static_cast<std::size_t>(slot)] = candidate;
    }
  }

  const Lattice& lattice_;
  const HeadingBins& bins_;
  float beam_nats_;
  float limit_nats_ = 0;  // see LimitOf
  std::vector<std::int32_t> slot_;  // of each (bin, cell) in the layer under construction
  std::vector<Move> moves_;
  std::vector<Layer> layers_;
};

DiscretePath Trace(const std::vector<Layer>& layers, std::size_t last, const Lattice& lattice,
                   const HeadingBins& bins, const std::vector<TimeNs>& times) {
  DiscretePath path;
  path.negative_log_posterior = layers.back()[last].nats;
  path.position_m.time_ns = times;
  path.heading_offset_rad.time_ns = times;
  path.position_m.value.resize(times.size());
  path.heading_offset_rad.value.resize(times.size());
  auto index = static_cast<std::int32_t>(last);
  for (std::size_t k = layers.size(); k-- > 0;) {
    const State& state = layers[k][static_cast<std::size_t>(index)];
    path.position_m.value[k] = lattice.centers_m()[static_cast<std::size_t>(state.cell)];
    path.heading_offset_rad.value[k] = bins.offset_rad[static_cast<std::size_t>(state.bin)];
    index = state.previous;
  }
  // Bins on a circle: without this, interpolation would turn all the way round between the last
  // and the first.
  std::vector<double>& offset = path.heading_offset_rad.value;
  for (std::size_t k = 1; k < offset.size(); ++k) {
    offset[k] = offset[k - 1] + WrapAngle(offset[k] - offset[k - 1]);
  }
  return path;
}

double MeanDistance(const DiscretePath& a, const DiscretePath& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.position_m.size(); ++i) {
    sum += (a.position_m.value[i] - b.position_m.value[i]).norm();
  }
  return sum / static_cast<double>(a.position_m.size());
}

// The best path, and the best of each end state whose path differs from all better ones.
std::vector<DiscretePath> DistinctPaths(const Trellis& trellis, const Lattice& lattice,
                                        const HeadingBins& bins, const std::vector<TimeNs>& times,
                                        const DiscreteSettings& settings) {
  constexpr std::size_t kMaxTraces = 2000;
  const Layer& ends = trellis.layers().back();
  std::vector<std::size_t> order(ends.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return ends[a].nats < ends[b].nats; });
  std::vector<DiscretePath> paths;
  for (std::size_t i = 0; i < std::min(order.size(), kMaxTraces); ++i) {
    DiscretePath path = Trace(trellis.layers(), order[i], lattice, bins, times);
    const bool known = std::any_of(paths.begin(), paths.end(), [&](const DiscretePath& better) {
      return MeanDistance(path, better) < settings.distinct_m;
    });
    if (!known) paths.push_back(std::move(path));
    if (static_cast<int>(paths.size()) >= settings.paths) break;
  }
  return paths;
}

}  // namespace

Eigen::Vector2d DiscretePath::PositionAt(const DeadReckonedPath& walk, TimeNs time_ns) const {
  const auto& times = position_m.time_ns;
  const auto after = std::upper_bound(times.begin(), times.end(), time_ns);
  if (after == times.begin()) return position_m.value.front();
  const auto next = static_cast<std::size_t>(after - times.begin());
  const std::size_t last = next - 1;
  // Without any heading the walk's direction means nothing.
  const bool turns = walk.source != HeadingSource::kNone;
  const Eigen::Rotation2Dd turn(heading_offset_rad.value[last]);
  const auto moved_until = [&](TimeNs time) -> Eigen::Vector2d {
    if (!turns) return Eigen::Vector2d::Zero();
    return turn * (walk.PositionAt(time) - walk.PositionAt(times[last]));
  };
  const Eigen::Vector2d along = position_m.value[last] + moved_until(time_ns);
  if (after == times.end()) return along;
  const Eigen::Vector2d missed =
      position_m.value[next] - position_m.value[last] - moved_until(times[next]);
  const double share =
      SecondsBetween(times[last], time_ns) / SecondsBetween(times[last], times[next]);
  return along + share * missed;
}

std::vector<DiscretePath> SmoothOnLattice(const Site& site, const Evidence& evidence,
                                          const DeadReckonedPath& walk,
                                          const FactorSettings& factors,
                                          const DiscreteSettings& settings,
                                          const FloorPath& floors) {
  const Lattice lattice(site, floors.Floors(), settings.spacing_m, settings.reach_m);
  if (lattice.size() == 0) return {};
  Emissions emissions(lattice, walk, EpochTimes(evidence, settings.epoch_s));
  for (const RadioMap* map : MapsOnPath(site, factors.fingerprint, floors)) {
    emissions.AddSweeps(site, *map, evidence, factors, floors);
  }
  for (const PositionAnchor& anchor : evidence.anchors) {
    if (anchor.floor == floors.At(anchor.time_ns)) emissions.AddAnchor(anchor);
  }
  if (!emissions.any()) return {};

  const std::vector<TimeNs>& times = emissions.times();
  const HeadingBins bins =
      MakeBins(walk.source, factors.heading_offset, settings, SecondsBetween(times[0], times[1]));
  Trellis trellis(lattice, bins, settings.beam_nats);
  trellis.Begin(emissions.at(0));
  for (std::size_t k = 1; k < times.size(); ++k) {
    const Transition transition =
        MakeTransition(evidence, walk, times[k - 1], times[k], factors, settings);
    trellis.Advance(transition, emissions.at(k));
  }
  return DistinctPaths(trellis, lattice, bins, times, settings);
}

}  // namespace walkgraph
