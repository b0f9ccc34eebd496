#include "solvers/baselines/discrete_smoother.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "data/angle.h"
#include "factors/area.h"
#include "factors/magnetic.h"
#include "factors/map_sweeps.h"
#include "solvers/baselines/discrete_motion.h"
#include "solvers/baselines/lattice.h"
#include "solvers/baselines/sweep_costs.h"
#include "solvers/baselines/trellis.h"

namespace walkgraph {
namespace {

// Readings of a sweep closer in time than this are placed together: 0.3 m of walking.
constexpr double kPartSeconds = 0.5;

std::vector<TimeNs> EpochTimes(const Evidence& evidence, double epoch_s) {
  const double span_s = SecondsBetween(evidence.begin_ns, evidence.end_ns);
  const int intervals = std::max(1, static_cast<int>(std::lround(span_s / epoch_s)));
  std::vector<TimeNs> times;
  for (int i = 0; i <= intervals; ++i) {
    times.push_back(evidence.begin_ns + DurationNs(span_s * i / intervals));
  }
  return times;
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
    std::vector<MapSweep> sweeps =
        CollectMapSweeps(site, map, evidence, settings.fingerprint, floors, kPartSeconds);
    if (sweeps.empty()) return;
    for (MapSweep& sweep : sweeps) sweep.facing = FacingAt(sweep.mean_heard_ns);
    const auto costs =
        EvaluateSweeps(map, lattice_.centers_m(),
                       PriorOfRssiOffset(site, evidence, map.radio, settings.rssi_offset),
                       settings.fingerprint.loss, sweeps);
    for (std::size_t s = 0; s < sweeps.size(); ++s) AddMoved(sweeps[s].mean_heard_ns, *costs[s]);
    any_ = true;
  }

  void AddAnchor(const PositionAnchor& anchor) {
    const std::size_t epoch = NearestTime(times_, anchor.time_ns);
    const Eigen::Vector2d at = anchor.position_m - MovedSince(epoch, anchor.time_ns);
    const double variance = anchor.sigma_m * anchor.sigma_m + QuantisationVariance();
    for (std::size_t c = 0; c < lattice_.size(); ++c) {
      const double squared = (lattice_.centers_m()[c] - at).squaredNorm();
      nats_[epoch][c] += static_cast<float>(0.5 * squared / variance);
    }
    any_ = true;
  }

  void AddMagneticLooks(const std::vector<MagneticLook>& looks) {
    std::map<const MagneticMap*, MagneticGrid> grids;
    for (const MagneticLook& look : looks) {
      const auto grid = grids.try_emplace(look.map, *look.map, lattice_.centers_m()).first;
      AddMoved(look.time_ns, grid->second.Evaluate(look));
    }
  }

  // Every epoch stands for its share of the walk, as a node of the graph does.
  void AddAreas(const Site& site, const AreaSettings& settings, const FloorPath& floors) {
    WalkAreas areas(site, settings, floors);
    std::map<const AreaField*, std::vector<float>> costs;
    for (std::size_t k = 0; k < times_.size(); ++k) {
      const AreaField* area = areas.At(times_[k]);
      if (area == nullptr) continue;
      std::vector<float>& cost = costs[area];
      if (cost.empty()) cost = AreaCost(*area, settings);
      for (std::size_t c = 0; c < lattice_.size(); ++c) nats_[k][c] += cost[c];
    }
  }

  double QuantisationVariance() const { return lattice_.spacing_m() * lattice_.spacing_m() / 12.0; }
  bool any() const { return any_; }
  const std::vector<TimeNs>& times() const { return times_; }
  const std::vector<float>& at(std::size_t epoch) const { return nats_[epoch]; }

 private:
  std::vector<float> AreaCost(const AreaField& area, const AreaSettings& settings) const {
    const double epoch_s = SecondsBetween(times_[0], times_[1]);
    std::vector<float> cost;
    for (const Eigen::Vector2d& center : lattice_.centers_m()) {
      const double outside_m = std::max(0.0, area.At(center.x(), center.y()));
      const double sigmas = outside_m / settings.sigma_m;
      cost.push_back(static_cast<float>(0.5 * sigmas * sigmas * epoch_s));
    }
    return cost;
  }

  // Unknown without an absolute heading, which alone tells the direction of the dead reckoning: the
  // mean over all directions is zero.
  Eigen::Vector2d MovedSince(std::size_t epoch, TimeNs time_ns) const {
    if (walk_.source != HeadingSource::kAbsolute) return Eigen::Vector2d::Zero();
    return walk_.PositionAt(time_ns) - walk_.PositionAt(times_[epoch]);
  }

  // The same of the direction of walking. An offset of the heading turns a shadow by less than it
  // is known.
  Eigen::Vector2d FacingAt(TimeNs time_ns) const {
    if (walk_.source != HeadingSource::kAbsolute) return Eigen::Vector2d::Zero();
    return DirectionOf(walk_.HeadingAt(time_ns));
  }

  // A reading heard between epochs speaks of the cell that the person passed then.
  void AddMoved(TimeNs time_ns, const std::vector<float>& cost) {
    const std::size_t epoch = NearestTime(times_, time_ns);
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

DiscretePath Trace(const std::vector<TrellisLayer>& layers, std::size_t last,
                   const Lattice& lattice, const HeadingBins& bins,
                   const std::vector<TimeNs>& times) {
  DiscretePath path;
  path.negative_log_posterior = layers.back()[last].nats;
  path.position_m.time_ns = times;
  path.heading_offset_rad.time_ns = times;
  path.position_m.value.resize(times.size());
  path.heading_offset_rad.value.resize(times.size());
  auto index = static_cast<std::int32_t>(last);
  for (std::size_t k = layers.size(); k-- > 0;) {
    const TrellisState& state = layers[k][static_cast<std::size_t>(index)];
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
  const TrellisLayer& ends = trellis.layers().back();
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
  emissions.AddMagneticLooks(CollectMagneticLooks(site, evidence, factors.magnetic, floors));
  emissions.AddAreas(site, factors.area, floors);

  const std::vector<TimeNs>& times = emissions.times();
  const HeadingBins bins =
      MakeBins(walk.source, factors, settings, SecondsBetween(times[0], times[1]));
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
