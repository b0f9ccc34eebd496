#include "solvers/baselines/trellis.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace walkgraph {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

}  // namespace

void Trellis::Begin(const std::vector<float>& emission) {
  TrellisLayer layer;
  for (int bin = 0; bin < bins_.size(); ++bin) {
    for (std::size_t c = 0; c < lattice_.size(); ++c) {
      layer.push_back({static_cast<std::int32_t>(c), bin, -1,
                       emission[c] + bins_.prior_nats[static_cast<std::size_t>(bin)]});
    }
  }
  layers_.push_back(Prune(std::move(layer)));
}

void Trellis::Advance(const Transition& transition, const std::vector<float>& emission) {
  const TrellisLayer& from = layers_.back();
  TrellisLayer to;
  limit_nats_ = LimitOf(from, transition, emission) + beam_nats_;
  for (int bin = 0; bin < bins_.size(); ++bin) {
    const double turn = bins_.offset_rad[static_cast<std::size_t>(bin)];
    const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(turn).toRotationMatrix();
    PrepareMoves(rotation * transition.displacement_m, transition.variance_m2);
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (from[i].bin == bin) Spread(from, static_cast<std::int32_t>(i), emission, &to);
    }
  }
  for (const TrellisState& state : to) slot_[Slot(state)] = -1;
  // A walk that leaves the lattice stays where it was rather than losing every state.
  layers_.push_back(to.empty() ? Stay(from) : Prune(std::move(to)));
}

std::size_t Trellis::Slot(const TrellisState& state) const {
  return static_cast<std::size_t>(state.bin) * lattice_.size() +
         static_cast<std::size_t>(state.cell);
}

TrellisLayer Trellis::Prune(TrellisLayer layer) const {
  float best = kInfinity;
  for (const TrellisState& state : layer) best = std::min(best, state.nats);
  std::erase_if(layer,
                [&](const TrellisState& state) { return !(state.nats <= best + beam_nats_); });
  return layer;
}

TrellisLayer Trellis::Stay(const TrellisLayer& from) {
  TrellisLayer layer = from;
  for (std::size_t i = 0; i < layer.size(); ++i) {
    layer[i].previous = static_cast<std::int32_t>(i);
  }
  return layer;
}

void Trellis::PrepareMoves(const Eigen::Vector2d& displacement_m, double variance_m2) {
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

float Trellis::LimitOf(const TrellisLayer& from, const Transition& transition,
                       const std::vector<float>& emission) {
  const auto best = std::min_element(
      from.begin(), from.end(),
      [](const TrellisState& a, const TrellisState& b) { return a.nats < b.nats; });
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

void Trellis::Spread(const TrellisLayer& from, std::int32_t index,
                     const std::vector<float>& emission, TrellisLayer* to) {
  const TrellisState& state = from[static_cast<std::size_t>(index)];
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

void Trellis::Relax(const TrellisState& candidate, TrellisLayer* to) {
  std::int32_t& slot = slot_[Slot(candidate)];
  if (slot < 0) {
    slot = static_cast<std::int32_t>(to->size());
    to->push_back(candidate);
  } else if (candidate.nats < (*to)[static_cast<std::size_t>(slot)].nats) {
    (*to)[static_cast<std::size_t>(slot)] = candidate;
  }
}

}  // namespace walkgraph
