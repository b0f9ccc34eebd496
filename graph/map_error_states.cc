#include "graph/map_error_states.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "factors/map_error.h"
#include "factors/map_look.h"
#include "graph/node_times.h"

namespace walkgraph {
namespace {

constexpr int kMostGiven = 3;
// Errors at one and the same place and time are still not one: no weight goes to infinity.
constexpr double kLeastVariance = 1e-4;

template <int kGiven>
GraphFactor MakeFactor(const SparseConditional& conditional, double sigma_m,
                       std::vector<int> blocks, std::string type) {
  MapErrorFactor<kGiven> factor;
  std::copy_n(conditional.weights.data(), kGiven, factor.weight.begin());
  factor.sigma_m = sigma_m * std::sqrt(std::max(conditional.variance, kLeastVariance));
  return MakeGraphFactor(factor, std::move(blocks), std::move(type));
}

GraphFactor MakeMapErrorFactor(const MapErrorKnots& knots, int knot,
                               const SparseConditional& conditional, BlockKind kind) {
  std::vector<int> blocks;
  for (const int given : conditional.given) {
    blocks.push_back(knots.state.blocks[static_cast<std::size_t>(given)]);
  }
  blocks.push_back(knots.state.blocks[static_cast<std::size_t>(knot)]);
  std::string type = std::string(BlockName(kind)) + "_field";
  const double sigma_m = knots.kernel.sigma_m;
  switch (conditional.given.size()) {
    case 0:
      return MakeFactor<0>(conditional, sigma_m, std::move(blocks), std::move(type));
    case 1:
      return MakeFactor<1>(conditional, sigma_m, std::move(blocks), std::move(type));
    case 2:
      return MakeFactor<2>(conditional, sigma_m, std::move(blocks), std::move(type));
    default:
      return MakeFactor<kMostGiven>(conditional, sigma_m, std::move(blocks), std::move(type));
  }
}

double Correlation(const MapErrorKnots& knots, const std::vector<KnotPlace>& places, int a, int b) {
  const KnotPlace& one = places[static_cast<std::size_t>(a)];
  const KnotPlace& other = places[static_cast<std::size_t>(b)];
  if (one.floor != other.floor) return 0;
  const Knots& times = knots.state.knots;
  return knots.kernel.Correlation((one.position_m - other.position_m).norm(),
                                  SecondsBetween(times.Time(a), times.Time(b)));
}

bool Same(const SparseConditional& a, const SparseConditional& b) {
  return a.given == b.given && a.weights == b.weights && a.variance == b.variance;
}

void Condition(std::size_t knot, const SparseConditional& conditional, MapErrorKnots* knots,
               FactorGraph* graph) {
  if (Same(conditional, knots->conditionals[knot])) return;
  const BlockKind kind = graph->block(knots->state.blocks[knot]).id.kind;
  graph->ReplaceFactor(knots->factors[knot],
                       MakeMapErrorFactor(*knots, static_cast<int>(knot), conditional, kind));
  knots->conditionals[knot] = conditional;
}

// Chooses one after the other the variables that tell most of one of unit variance.
class NeighbourSearch {
 public:
  NeighbourSearch(int index, const std::function<double(int, int)>& correlation)
      : correlation_(correlation) {
    constexpr double kLeastCorrelation = 0.02;
    for (int i = 0; i < index; ++i) {
      const double with_own = correlation(i, index);
      if (with_own > kLeastCorrelation) candidates_.push_back({i, {}, with_own});
    }
  }

  const SparseConditional& found() const { return found_; }

  // Takes the next one; false where none takes its share of what is left.
  bool Add() {
    constexpr double kLeastShare = 0.01;
    const Eigen::LDLT<Eigen::MatrixXd> among(among_);
    auto best = candidates_.end();
    double largest_gain = kLeastShare * found_.variance;
    for (auto candidate = candidates_.begin(); candidate != candidates_.end(); ++candidate) {
      const double gain = Gain(*candidate, among);
      if (gain <= largest_gain) continue;
      largest_gain = gain;
      best = candidate;
    }
    if (best == candidates_.end()) return false;
    Take(*best);
    candidates_.erase(best);
    for (Candidate& candidate : candidates_) {
      candidate.with_given.conservativeResize(own_.size());
      candidate.with_given[own_.size() - 1] = correlation_(candidate.index, found_.given.back());
    }
    return true;
  }

 private:
  struct Candidate {
    int index;
    Eigen::VectorXd with_given;  // correlations with those chosen so far
    double with_own;
  };

  // What a candidate takes of the variance that those chosen leave.
  double Gain(const Candidate& candidate, const Eigen::LDLT<Eigen::MatrixXd>& among) const {
    double left = 1, together = candidate.with_own;  // given the chosen
    if (!found_.given.empty()) {
      const Eigen::VectorXd weights = among.solve(candidate.with_given);
      left -= weights.dot(candidate.with_given);
      together -= weights.dot(own_);
    }
    return left < kLeastVariance ? 0 : together * together / left;
  }

  void Take(const Candidate& candidate) {
    const Eigen::Index chosen = own_.size();
    among_.conservativeResize(chosen + 1, chosen + 1);
    among_(chosen, chosen) = 1;
    among_.col(chosen).head(chosen) = candidate.with_given;
    among_.row(chosen).head(chosen) = candidate.with_given.transpose();
    own_.conservativeResize(chosen + 1);
    own_[chosen] = candidate.with_own;
    found_.given.push_back(candidate.index);
    found_.weights = among_.ldlt().solve(own_);
    found_.variance = 1 - found_.weights.dot(own_);
  }

  const std::function<double(int, int)>& correlation_;
  std::vector<Candidate> candidates_;
  SparseConditional found_;
  Eigen::MatrixXd among_;  // correlations of the chosen
  Eigen::VectorXd own_;    // theirs with the variable
};

}  // namespace

std::vector<KnotPlace> KnotPlaces(const MapErrorKnots& knots, const WalkGraph& walk,
                                  TimeNs now_ns) {
  const Knots& times = knots.state.knots;
  const auto position = [&walk](std::size_t node) {
    return Eigen::Map<const Eigen::Vector2d>(walk.graph.value(walk.position[node]));
  };
  std::vector<KnotPlace> places;
  std::size_t node = 0;
  for (int k = 0; k < times.count() && times.Time(k) <= now_ns; ++k) {
    const bool last = k + 1 == times.count();
    const TimeNs end_ns = last ? now_ns + 1 : std::min(times.Time(k + 1), now_ns + 1);
    const std::size_t first = node;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (; node < walk.node_ns.size() && walk.node_ns[node] < end_ns; ++node) sum += position(node);
    const TimeNs middle_ns = times.Time(k) + (end_ns - times.Time(k)) / 2;
    // Nodes are a second apart at most: only a knot shorter than that can be without.
    const auto nearest = static_cast<std::size_t>(FindBracket(walk.node_ns, middle_ns).before);
    places.push_back({node > first ? sum / static_cast<double>(node - first)
                                   : Eigen::Vector2d(position(nearest)),
                      walk.floors.At(middle_ns)});
  }
  return places;
}

std::vector<double> WideningOfKnots(const MapErrorKnots& knots, const WalkGraph& walk,
                                    TimeNs now_ns) {
  std::vector<double> widening;
  for (const KnotPlace& place : KnotPlaces(knots, walk, now_ns)) {
    double& ratio = widening.emplace_back(1.0);
    for (const RadioMap* map : knots.widened_by) {
      if (map->floor != place.floor) continue;
      const double growth_per_sigma = map->map_error_growth / knots.kernel.sigma_m;
      ratio = std::max(ratio, ErrorRatioAt(*map, growth_per_sigma, place.position_m).value);
    }
  }
  return widening;
}

SparseConditional ConditionOnEarlier(int index, const std::function<double(int, int)>& correlation,
                                     int most) {
  NeighbourSearch search(index, correlation);
  for (int i = 0; i < most && search.Add(); ++i) continue;
  return search.found();
}

KnotBlocks AddMapErrorState(BlockKind kind, const MapErrorSettings& settings, double sigma_m,
                            const std::vector<const RadioMap*>& widened_by, WalkGraph* walk) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(2);
  const TimeNs begin_ns = walk->node_ns.front();
  if (settings.mode != StateMode::kActive || sigma_m <= 0) {
    return {Knots(begin_ns, begin_ns, 1.0),
            {walk->graph.AddBlock({kind, 0}, begin_ns, zero, true)}};
  }
  const Knots times(begin_ns, walk->node_ns.back(), settings.knot_s);
  const MapErrorKernel kernel{sigma_m, settings.correlation_m, settings.correlation_s};
  MapErrorKnots knots{{times, {}}, {}, kernel, {}, {}, widened_by};
  for (int k = 0; k < times.count(); ++k) {
    knots.state.blocks.push_back(walk->graph.AddBlock({kind, k}, times.Time(k), zero));
  }
  for (int k = 0; k < times.count(); ++k) {
    SparseConditional& conditional = knots.as_walked.emplace_back();
    if (k > 0 && walk->floors.At(times.Time(k - 1)) == walk->floors.At(times.Time(k))) {
      const double rho =
          knots.kernel.Correlation(Interpolate(walk->walked_m, times.Time(k)) -
                                       Interpolate(walk->walked_m, times.Time(k - 1)),
                                   settings.knot_s);
      conditional = {{k - 1}, Eigen::VectorXd::Constant(1, rho), 1 - rho * rho};
    }
    knots.factors.push_back(walk->graph.AddFactor(MakeMapErrorFactor(knots, k, conditional, kind)));
  }
  knots.conditionals = knots.as_walked;
  walk->map_errors.push_back(knots);
  return knots.state;
}

MapErrorConditionals Conditionals(const WalkGraph& walk) {
  MapErrorConditionals all;
  for (const MapErrorKnots& knots : walk.map_errors) all.push_back(knots.conditionals);
  return all;
}

MapErrorConditionals ConditionalsAsWalked(const WalkGraph& walk) {
  MapErrorConditionals all;
  for (const MapErrorKnots& knots : walk.map_errors) all.push_back(knots.as_walked);
  return all;
}

void SetConditionals(const MapErrorConditionals& conditionals, WalkGraph* walk) {
  for (std::size_t map = 0; map < walk->map_errors.size(); ++map) {
    for (std::size_t k = 0; k < conditionals[map].size(); ++k) {
      Condition(k, conditionals[map][k], &walk->map_errors[map], &walk->graph);
    }
  }
}

void ConditionOnPlaces(WalkGraph* walk) {
  const auto all = [](int) { return true; };
  ConditionNewOnPlaces(walk->node_ns.back(), all, all, walk);
}

void ConditionNewOnPlaces(TimeNs now_ns, const std::function<bool(int)>& is_new,
                          const std::function<bool(int)>& is_known, WalkGraph* walk) {
  for (MapErrorKnots& knots : walk->map_errors) {
    const std::vector<int>& blocks = knots.state.blocks;
    const std::vector<KnotPlace> places = KnotPlaces(knots, *walk, now_ns);
    const auto correlation = [&](int a, int b) {
      return is_known(blocks[static_cast<std::size_t>(a)]) ? Correlation(knots, places, a, b) : 0.0;
    };
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (!is_new(blocks[k])) continue;
      Condition(k, ConditionOnEarlier(static_cast<int>(k), correlation, kMostGiven), &knots,
                &walk->graph);
    }
  }
}

}  // namespace walkgraph
