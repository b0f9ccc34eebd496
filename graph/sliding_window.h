#ifndef WALKGRAPH_GRAPH_SLIDING_WINDOW_H_
#define WALKGRAPH_GRAPH_SLIDING_WINDOW_H_

#include <Eigen/Core>
#include <vector>

#include "graph/factor_graph.h"
#include "graph/graph_part.h"

namespace walkgraph {

// The part of a graph that is still open to change. Blocks and factors enter; blocks leave by
// marginalisation, which replaces them and every factor on them by a prior on their neighbours.
//
// Consistency: once a block is touched by a prior, every factor that is later marginalised takes
// its Jacobian at the block's first estimate (its value when it was first touched), so that all
// that was ever marginalised is linearised at one point per block. Directions that no factor sees,
// such as the rotation of a dead-reckoned walk, then stay unseen; with Jacobians at the latest
// values they would gain information that nobody measured (Huang, Mourikis and Roumeliotis, 2009).
// Residuals are taken at the latest values.
class SlidingWindow {
 public:
  // Keeps the pointer. The graph must not grow while the window is in use.
  explicit SlidingWindow(FactorGraph* graph);

  const GraphPart& part() const { return part_; }
  bool IsActive(int block) const { return state_[static_cast<std::size_t>(block)] == kActive; }
  bool HasLeft(int block) const { return state_[static_cast<std::size_t>(block)] == kLeft; }

  // Sum over all marginalisations of log det of the information of the blocks that left, given
  // those that stayed: with that of the part it makes the determinant of all that was ever in the
  // window, which windows in other modes are weighed against.
  double left_log_determinant() const { return left_log_determinant_; }

  void AddBlock(int block);

  // Adds a factor. False if it cannot take part because a block of its has left: such late evidence
  // is the caller's to count. Precondition: its other blocks are active or constant.
  bool AddFactor(int factor);

  // Replaces all that marginalised blocks left behind, which a caller knows to be wrong, by one
  // prior on active blocks.
  void ReplacePriors(LinearPrior prior);

  // Removes active blocks; their values stay in the graph as they are. False, and nothing changes,
  // where the linearised factors are not finite.
  bool Marginalize(const std::vector<int>& leaving);

 private:
  enum State : char { kWaiting, kActive, kLeft };

  FactorGraph* graph_;
  GraphPart part_;
  std::vector<State> state_;     // by block
  std::vector<bool> has_first_;  // by block: touched by a prior
  double left_log_determinant_ = 0;
  Eigen::VectorXd first_estimate_;  // as FactorGraph::values(), where has_first_
};

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_SLIDING_WINDOW_H_
