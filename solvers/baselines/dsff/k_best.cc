#include "solvers/baselines/dsff/k_best.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace walkgraph {

KBestViterbi::KBestViterbi(std::size_t states, int k, double beam_nats)
    : k_(static_cast<std::size_t>(std::max(1, k))), beam_nats_(beam_nats), ways_(states * k_) {}

void KBestViterbi::Begin(std::span<const double> log_emission) {
  layers_.clear();
  ways_.assign(ways_.size(), Way());
  for (std::size_t s = 0; s < log_emission.size(); ++s) Offer(static_cast<int>(s), 0, -1);
  if (!Settle(log_emission)) throw std::invalid_argument("no state can emit the first evidence");
}

void KBestViterbi::Restart(std::span<const double> log_emission) {
  const auto best = static_cast<std::int32_t>(BestWay());
  const double log_score = layers_.back()[static_cast<std::size_t>(best)].log_score;
  ways_.assign(ways_.size(), Way());
  for (std::size_t s = 0; s < log_emission.size(); ++s) Offer(static_cast<int>(s), log_score, best);
  if (!Settle(log_emission)) throw std::invalid_argument("no state can emit the evidence");
}

bool KBestViterbi::Offer(int to, double log_score, std::int32_t previous) {
  if (!std::isfinite(log_score)) return false;
  Way* const first = &ways_[static_cast<std::size_t>(to) * k_];
  std::size_t rank = k_;
  while (rank > 0 && (first[rank - 1].state < 0 || log_score > first[rank - 1].log_score)) --rank;
  if (rank == k_) return false;
  std::move_backward(first + rank, first + k_ - 1, first + k_);
  first[rank] = {to, previous, log_score};
  return true;
}

bool KBestViterbi::Settle(std::span<const double> log_emission) {
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    if (ways_[i].state < 0) continue;
    ways_[i].log_score += log_emission[i / k_];
    best = std::max(best, ways_[i].log_score);
  }
  if (!std::isfinite(best)) return false;
  Layer layer;
  for (const Way& way : ways_) {
    if (way.state >= 0 && way.log_score >= best - beam_nats_) layer.push_back(way);
  }
  layers_.push_back(std::move(layer));
  return true;
}

std::size_t KBestViterbi::BestWay() const {
  const Layer& last = layers_.back();
  const auto best = std::max_element(last.begin(), last.end(), [](const Way& a, const Way& b) {
    return a.log_score < b.log_score;
  });
  return static_cast<std::size_t>(best - last.begin());
}

KBestViterbi::Step KBestViterbi::LastStep() const {
  const Way& way = layers_.back()[BestWay()];
  if (layers_.size() < 2) return {way.state, way.state};
  return {layers_[layers_.size() - 2][static_cast<std::size_t>(way.previous)].state, way.state};
}

std::vector<KBestViterbi::Trace> KBestViterbi::Best() const {
  const Layer& last = layers_.back();
  std::vector<std::size_t> order(last.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t count = std::min(k_, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                    [&](std::size_t a, std::size_t b) {
                      return last[a].log_score != last[b].log_score
                                 ? last[a].log_score > last[b].log_score
                                 : a < b;
                    });
  std::vector<Trace> traces;
  for (std::size_t i = 0; i < count; ++i) {
    Trace trace{last[order[i]].log_score, std::vector<int>(layers_.size())};
    auto index = static_cast<std::int32_t>(order[i]);
    for (std::size_t e = layers_.size(); e-- > 0;) {
      const Way& way = layers_[e][static_cast<std::size_t>(index)];
      trace.states[e] = way.state;
      index = way.previous;
    }
    traces.push_back(std::move(trace));
  }
  return traces;
}

}  // namespace walkgraph
