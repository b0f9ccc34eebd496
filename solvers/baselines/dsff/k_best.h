#ifndef WALKGRAPH_SOLVERS_BASELINES_DSFF_K_BEST_H_
#define WALKGRAPH_SOLVERS_BASELINES_DSFF_K_BEST_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace walkgraph {

// The k most likely traces through a hidden Markov model, epoch by epoch: every state keeps its k
// best ways. With k = 1 this is Viterbi's algorithm. Source: Seshadri and Sundberg, IEEE Trans.
// Communications 42 (1994), the parallel list Viterbi algorithm.
class KBestViterbi {
 public:
  struct Trace {
    double log_score = 0;
    std::vector<int> states;  // by epoch
  };

  // States whose best way is more than `beam_nats` worse than the best of all are left out.
  KBestViterbi(std::size_t states, int k, double beam_nats);

  // `log_emission` by state; -infinity forbids one.
  void Begin(std::span<const double> log_emission);

  // One epoch on. `transitions(from, relax)` calls relax(to, log_probability) for every state that
  // can be reached. False, and nothing changed, where none can be.
  template <typename Transitions>
  bool Advance(const Transitions& transitions, std::span<const double> log_emission) {
    ways_.assign(ways_.size(), Way());
    const Layer& last = layers_.back();
    for (std::size_t i = 0; i < last.size(); ++i) {
      if (i > 0 && last[i].state == last[i - 1].state) continue;
      transitions(last[i].state, [&](int to, double log_probability) {
        for (std::size_t r = i; r < last.size() && last[r].state == last[i].state; ++r) {
          const auto previous = static_cast<std::int32_t>(r);
          if (!Offer(to, last[r].log_score + log_probability, previous)) break;
        }
      });
    }
    return Settle(log_emission);
  }

  // An epoch that nothing leads to: all states from the best trace so far.
  void Restart(std::span<const double> log_emission);

  // The last two states of the best trace; the same twice at the first epoch.
  struct Step {
    int from = 0, to = 0;
  };
  Step LastStep() const;

  // Up to k, best first. Begin() must have come before.
  std::vector<Trace> Best() const;

 private:
  struct Way {
    int state = -1;
    std::int32_t previous = -1;  // index into the layer before
    double log_score = 0;
  };
  using Layer = std::vector<Way>;  // by state, then best first

  // Keeps a way among the k best of a state; false where it is not one of them.
  bool Offer(int to, double log_score, std::int32_t previous);
  bool Settle(std::span<const double> log_emission);
  std::size_t BestWay() const;

  std::size_t k_;
  double beam_nats_;
  std::vector<Way> ways_;  // k for each state of the epoch under construction, best first
  std::vector<Layer> layers_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_DSFF_K_BEST_H_
