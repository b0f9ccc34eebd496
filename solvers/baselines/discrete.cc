#include "solvers/baselines/discrete.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace walkgraph {

double LogSumExp(std::span<const double> values) {
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  if (values.empty()) return kNone;
  const double largest = *std::max_element(values.begin(), values.end());
  if (largest == kNone) return kNone;
  double sum = 0;
  for (const double value : values) sum += std::exp(value - largest);
  return largest + std::log(sum);
}

std::vector<double> PredictDistribution(const TransitionRows& rows,
                                        std::span<const double> probability) {
  double everywhere = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) everywhere += rows.elsewhere[i] * probability[i];
  std::vector<double> next(rows.size(), everywhere);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const TransitionRows::Entry& entry : rows.Row(i)) {
      next[static_cast<std::size_t>(entry.to)] +=
          (entry.probability - rows.elsewhere[i]) * probability[i];
    }
  }
  return next;
}

std::vector<double> UpdateDistribution(std::span<const double> prior,
                                       std::span<const double> log_likelihood) {
  std::vector<double> posterior(prior.size());
  for (std::size_t i = 0; i < prior.size(); ++i) {
    posterior[i] = std::log(prior[i]) + log_likelihood[i];
  }
  const double total = LogSumExp(posterior);
  if (!std::isfinite(total)) {
    std::fill(posterior.begin(), posterior.end(), 1 / static_cast<double>(prior.size()));
    return posterior;
  }
  for (double& value : posterior) value = std::exp(value - total);
  return posterior;
}

ViterbiStep AdvanceViterbi(const TransitionRows& rows, std::span<const double> log_score) {
  std::vector<double> elsewhere(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    elsewhere[i] = log_score[i] + std::log(rows.elsewhere[i]);
  }
  const int best = ArgMax(elsewhere);
  ViterbiStep step{std::vector<double>(rows.size(), elsewhere[static_cast<std::size_t>(best)]),
                   std::vector<int>(rows.size(), best)};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const TransitionRows::Entry& entry : rows.Row(i)) {
      const auto to = static_cast<std::size_t>(entry.to);
      const double score = log_score[i] + std::log(entry.probability);
      const bool first_of_equals =
          score == step.log_score[to] && static_cast<int>(i) < step.from[to];
      if (score > step.log_score[to] || first_of_equals) {
        step.log_score[to] = score;
        step.from[to] = static_cast<int>(i);
      }
    }
  }
  return step;
}

std::vector<int> TraceViterbi(const std::vector<std::vector<int>>& from,
                              std::span<const double> last_log_score) {
  std::vector<int> path(from.size() + 1);
  path.back() = ArgMax(last_log_score);
  for (std::size_t k = from.size(); k > 0; --k) {
    path[k - 1] = from[k - 1][static_cast<std::size_t>(path[k])];
  }
  return path;
}

int ArgMax(std::span<const double> values) {
  return static_cast<int>(std::max_element(values.begin(), values.end()) - values.begin());
}

Eigen::Matrix2d SecondMoment(std::span<const Eigen::Vector2d> positions_m,
                             std::span<const double> probability, const Eigen::Vector2d& about_m) {
  Eigen::Matrix2d moment = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < positions_m.size(); ++i) {
    const Eigen::Vector2d d = positions_m[i] - about_m;
    moment += probability[i] * d * d.transpose();
  }
  return moment;
}

}  // namespace walkgraph
