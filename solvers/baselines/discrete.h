#ifndef WALKGRAPH_SOLVERS_BASELINES_DISCRETE_H_
#define WALKGRAPH_SOLVERS_BASELINES_DISCRETE_H_

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace walkgraph {

// Hidden Markov models over a few thousand states, whose transitions are mostly one small constant
// per row (or zero): the recursions cost the listed entries, not the square of the states.

// log of the sum of exp(values), without overflow; -infinity for nothing or only -infinity.
double LogSumExp(std::span<const double> values);

// A row-stochastic matrix: from state i to a listed state with its own probability, to each other
// one with elsewhere[i]. No listed probability is smaller than its row's `elsewhere`.
struct TransitionRows {
  struct Entry {
    int to = 0;
    double probability = 0;
  };
  std::vector<double> elsewhere;
  std::vector<std::size_t> begin{0};  // of each row's entries; one more than there are rows
  std::vector<Entry> entries;

  std::size_t size() const { return elsewhere.size(); }
  std::span<const Entry> Row(std::size_t i) const {
    return std::span(entries).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

// One step of the forward recursion: the distribution of the next state before its observation.
std::vector<double> PredictDistribution(const TransitionRows& rows,
                                        std::span<const double> probability);

// The distribution after an observation: proportional to prior * exp(log_likelihood). Uniform where
// the two have nothing in common. Sums to one.
std::vector<double> UpdateDistribution(std::span<const double> prior,
                                       std::span<const double> log_likelihood);

// One step of the Viterbi recursion: for each next state the best log score of a path to it, before
// its observation, and where that path was (of equal ones the lowest index).
struct ViterbiStep {
  std::vector<double> log_score;
  std::vector<int> from;
};
ViterbiStep AdvanceViterbi(const TransitionRows& rows, std::span<const double> log_score);

// The best path: ends in the state with the highest score and goes back through each step's `from`,
// first step first. One state more than there are steps.
std::vector<int> TraceViterbi(const std::vector<std::vector<int>>& from,
                              std::span<const double> last_log_score);

// Index of the largest value, of equal ones the first. Precondition: not empty.
int ArgMax(std::span<const double> values);

// Second moment of a distribution over positions about a point, m^2.
Eigen::Matrix2d SecondMoment(std::span<const Eigen::Vector2d> positions_m,
                             std::span<const double> probability, const Eigen::Vector2d& about_m);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_DISCRETE_H_
