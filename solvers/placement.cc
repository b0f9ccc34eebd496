#include "solvers/placement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "data/angle.h"
#include "factors/map_sweeps.h"
#include "solvers/baselines/lattice.h"
#include "solvers/baselines/sweep_costs.h"

namespace walkgraph {
namespace {

constexpr double kSpacingM = 3.0;       // half of what a scan alone can tell
constexpr double kReachM = 6.0;         // of the lattice around survey paths
constexpr double kDistinctM = 6.0;      // mean distance between two placements
constexpr double kMaxRotationDeg = 20;  // of an absolute heading
constexpr double kRotationStepDeg = 5;
constexpr double kCircleStepDeg = 10;

// -log p of evidence at one time, for every cell of the lattice, and where it is worth no more.
struct PlacedEvidence {
  TimeNs time_ns = 0;
  std::vector<float> nats;
  float outside_nats = 0;  // off the lattice: as bad as the worst cell
};

void Append(TimeNs time_ns, std::vector<float> nats, std::vector<PlacedEvidence>* placed) {
  const float worst = *std::max_element(nats.begin(), nats.end());
  placed->push_back({time_ns, std::move(nats), worst});
}

std::vector<PlacedEvidence> EvidenceOnLattice(const Site& site, const Evidence& evidence,
                                              const FactorSettings& settings,
                                              const FloorPath& floors, const Lattice& lattice) {
  std::vector<PlacedEvidence> placed;
  for (const RadioMap* map : MapsOnPath(site, settings.fingerprint, floors)) {
    const auto sweeps = CollectMapSweeps(site, *map, evidence, settings.fingerprint, floors);
    if (sweeps.empty()) continue;
    const auto nats =
        EvaluateSweeps(*map, lattice.centers_m(),
                       PriorOfRssiOffset(site, evidence, map->radio, settings.rssi_offset),
                       settings.fingerprint.loss, sweeps);
    for (std::size_t s = 0; s < sweeps.size(); ++s) {
      Append(sweeps[s].mean_heard_ns, *nats[s], &placed);
    }
  }
  for (const PositionAnchor& anchor : evidence.anchors) {
    if (anchor.floor != floors.At(anchor.time_ns)) continue;
    std::vector<float> nats;
    const double variance = anchor.sigma_m * anchor.sigma_m + kSpacingM * kSpacingM / 12.0;
    for (const Eigen::Vector2d& centre : lattice.centers_m()) {
      nats.push_back(
          static_cast<float>(0.5 * (centre - anchor.position_m).squaredNorm() / variance));
    }
    Append(anchor.time_ns, std::move(nats), &placed);
  }
  return placed;
}

// Rotations to try, with what the heading offset's prior makes of each.
struct Rotation {
  double angle_rad = 0;
  double prior_nats = 0;
};
std::vector<Rotation> Rotations(const DeadReckonedPath& walk, const HeadingOffsetSettings& offset) {
  std::vector<Rotation> rotations;
  if (walk.source != HeadingSource::kAbsolute) {
    for (double deg = 0; deg < 360; deg += kCircleStepDeg) {
      rotations.push_back({DegreesToRadians(deg), 0.0});
    }
    return rotations;
  }
  const double limit = offset.mode == StateMode::kActive ? kMaxRotationDeg : 0.0;
  for (double deg = -limit; deg <= limit; deg += kRotationStepDeg) {
    const double sigmas = DegreesToRadians(deg) / offset.prior_sigma_rad;
    rotations.push_back({DegreesToRadians(deg), 0.5 * sigmas * sigmas});
  }
  return rotations;
}

// Cost of every cell as the place of the walk's start, for one rotation.
std::vector<double> CostOfStarts(const std::vector<PlacedEvidence>& placed,
                                 const DeadReckonedPath& walk, const Lattice& lattice,
                                 const Rotation& rotation) {
  std::vector<double> cost(lattice.size(), rotation.prior_nats);
  const Eigen::Rotation2Dd turn(rotation.angle_rad);
  for (const PlacedEvidence& evidence : placed) {
    const Eigen::Vector2d moved = turn * walk.PositionAt(evidence.time_ns) / kSpacingM;
    const int columns = static_cast<int>(std::lround(moved.x()));
    const int rows = static_cast<int>(std::lround(moved.y()));
    for (std::size_t c = 0; c < cost.size(); ++c) {
      const std::int32_t cell = lattice.Neighbour(static_cast<std::int32_t>(c), columns, rows);
      cost[c] += cell == Lattice::kNoCell ? evidence.outside_nats
                                          : evidence.nats[static_cast<std::size_t>(cell)];
    }
  }
  return cost;
}

bool IsDistinct(const Placement& candidate, const std::vector<Placement>& chosen,
                const DeadReckonedPath& walk) {
  const auto& times = walk.position_m.time_ns;
  return std::all_of(chosen.begin(), chosen.end(), [&](const Placement& other) {
    double sum = 0;
    for (const TimeNs time : times) {
      sum += (candidate.At(walk, time) - other.At(walk, time)).norm();
    }
    return sum >= kDistinctM * static_cast<double>(times.size());
  });
}

}  // namespace

Eigen::Vector2d Placement::At(const DeadReckonedPath& walk, TimeNs time_ns) const {
  return start_m + Eigen::Rotation2Dd(rotation_rad) * walk.PositionAt(time_ns);
}

std::vector<Placement> PlaceDeadReckoning(const Site& site, const Evidence& evidence,
                                          const DeadReckonedPath& walk,
                                          const FactorSettings& settings, const FloorPath& floors,
                                          int count) {
  if (count <= 0) return {};
  const Lattice lattice(site, floors.Floors(), kSpacingM, kReachM);
  if (lattice.size() == 0) return {};
  const auto placed = EvidenceOnLattice(site, evidence, settings, floors, lattice);
  if (placed.empty()) return {};
  std::vector<Placement> all;
  for (const Rotation& rotation : Rotations(walk, settings.heading_offset)) {
    const std::vector<double> cost = CostOfStarts(placed, walk, lattice, rotation);
    for (std::size_t c = 0; c < cost.size(); ++c) {
      all.push_back({lattice.centers_m()[c], rotation.angle_rad, cost[c]});
    }
  }
  // Far more than are wanted, since neighbours of the best are not distinct from it.
  const auto middle =
      all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), std::size_t{2000}));
  std::partial_sort(all.begin(), middle, all.end(), [](const Placement& a, const Placement& b) {
    return a.cost_nats < b.cost_nats;
  });
  std::vector<Placement> chosen;
  for (auto it = all.begin(); it != middle && static_cast<int>(chosen.size()) < count; ++it) {
    if (IsDistinct(*it, chosen, walk)) chosen.push_back(*it);
  }
  return chosen;
}

}  // namespace walkgraph
