#include "eval/statistics/rank_test.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

namespace walkgraph {
namespace {

// Sorts indices by the value that they stand for; none of these may be NaN.
void SortByValue(const std::vector<double>& values, std::vector<std::size_t>* indices) {
  std::stable_sort(indices->begin(), indices->end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
}

// P(W+ <= w) where every rank counts with probability 1/2. Mean ranks are halves of whole numbers,
// so that twice the sum indexes the table.
double ExactLowerTail(const std::vector<double>& ranks, double w) {
  const auto total =
      static_cast<std::size_t>(std::lround(2.0 * std::accumulate(ranks.begin(), ranks.end(), 0.0)));
  std::vector<double> probability(total + 1, 0.0);
  probability[0] = 1.0;
  for (const double rank : ranks) {
    const auto doubled = static_cast<std::size_t>(std::lround(2.0 * rank));
    for (std::size_t sum = total + 1; sum-- > 0;) {
      const double with = sum >= doubled ? probability[sum - doubled] : 0.0;
      probability[sum] = 0.5 * (probability[sum] + with);
    }
  }
  const auto last = static_cast<std::size_t>(std::lround(2.0 * w));
  double tail = 0;
  for (std::size_t sum = 0; sum <= last; ++sum) tail += probability[sum];
  return tail;
}

double TwoSidedP(const std::vector<double>& ranks, double w_plus) {
  const double total = std::accumulate(ranks.begin(), ranks.end(), 0.0);
  const double smaller = std::min(w_plus, total - w_plus);
  if (static_cast<int>(ranks.size()) <= kExactSignedRankPairs) {
    return std::min(1.0, 2.0 * ExactLowerTail(ranks, smaller));
  }
  double variance = 0;
  for (const double rank : ranks) variance += 0.25 * rank * rank;
  const double z = (smaller - 0.5 * total) / std::sqrt(variance);
  return std::erfc(-z / std::numbers::sqrt2);
}

}  // namespace

std::vector<double> MidRanks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  SortByValue(values, &order);
  std::vector<double> ranks(values.size());
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
    const double mean = 0.5 * static_cast<double>(begin + 1 + end);
    for (std::size_t i = begin; i < end; ++i) ranks[order[i]] = mean;
  }
  return ranks;
}

SignedRankTest TestSignedRanks(const std::vector<double>& differences) {
  std::vector<double> kept, magnitudes;
  for (const double difference : differences) {
    if (difference == 0 || std::isnan(difference)) continue;
    kept.push_back(difference);
    magnitudes.push_back(std::abs(difference));
  }
  SignedRankTest test;
  test.n = static_cast<int>(kept.size());
  if (kept.empty()) return test;
  const std::vector<double> ranks = MidRanks(magnitudes);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] > 0) test.w_plus += ranks[i];
  }
  test.p_value = TwoSidedP(ranks, test.w_plus);
  return test;
}

std::vector<double> HolmCorrected(const std::vector<double>& p_values) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < p_values.size(); ++i) {
    if (!std::isnan(p_values[i])) order.push_back(i);
  }
  SortByValue(p_values, &order);
  std::vector<double> corrected = p_values;
  double last = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double scaled = static_cast<double>(order.size() - i) * p_values[order[i]];
    last = std::max(last, std::min(1.0, scaled));
    corrected[order[i]] = last;
  }
  return corrected;
}

}  // namespace walkgraph
