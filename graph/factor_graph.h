#ifndef WALKGRAPH_GRAPH_FACTOR_GRAPH_H_
#define WALKGRAPH_GRAPH_FACTOR_GRAPH_H_

#include <ceres/cost_function.h>
#include <ceres/loss_function.h>

#include <Eigen/Core>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "data/time.h"
#include "factors/cost.h"
#include "factors/settings.h"
#include "factors/state_blocks.h"

namespace walkgraph {

struct StateBlock {
  BlockId id;
  TimeNs time_ns = 0;     // of the node, or from when the knot holds
  bool constant = false;  // held at its value: part of the model, not of the unknowns
  int offset = 0;         // of its first coordinate in FactorGraph::values()
  int size() const { return BlockSize(id.kind); }
};

struct GraphFactor {
  std::string type;                // as statistics name it
  TimeNs arrival_ns = 0;           // when its evidence was there to be used
  bool absolute_position = false;  // it tells where the walk is, other than by ignorance
  // A sensor's reading of the state at one time, not a tie between times: what a filter updates
  // with.
  bool reading = false;
  // An inequality: it moves the mode and is left out of linear systems, for a border tells on which
  // side of it a pose is and not how far from it.
  bool one_sided = false;
  std::vector<int> blocks;  // in the order of the cost function's arguments
  std::unique_ptr<ceres::CostFunction> cost;
  std::unique_ptr<ceres::LossFunction> loss;  // none: the parabola
  // -log density = 1/2 rho(|residual|^2) + log_normaliser, nats.
  double log_normaliser = 0;
  // For statistics: the leading rows that are whitened measurements (all of a Gaussian factor's),
  // how many of them make one measurement, the weight that their squares carry, and the loss that
  // the cost function itself applied to each.
  int whitened_rows = 0;
  int dimension = 1;
  double weight = 1;
  LossSettings row_loss;
};

// A factor of fixed Gaussian shape (see factors/cost.h). The type is the factor's own name unless
// another one tells more.
template <typename Factor>
GraphFactor MakeGraphFactor(const Factor& factor, std::vector<int> blocks, std::string type = "") {
  GraphFactor result;
  result.type = type.empty() ? std::string(Factor::kName) : std::move(type);
  result.blocks = std::move(blocks);
  result.cost = MakeCost(factor);
  result.log_normaliser = factor.LogNormaliser();
  result.whitened_rows = Factor::kDimension;
  result.dimension = Factor::kDimension;
  return result;
}

// The unknowns of a problem and the factors on them. Owns everything; values of all blocks stand in
// one vector, so that a point of the state space is copied, kept and restored as one.
class FactorGraph {
 public:
  // `value` has BlockSize(id.kind) coordinates. Invalidates pointers from value(). Returns the
  // block's index. Throws std::invalid_argument where the size is another.
  int AddBlock(BlockId id, TimeNs time_ns, const Eigen::VectorXd& value, bool constant = false);

  // Throws std::invalid_argument unless the blocks exist and have the sizes of the cost function.
  int AddFactor(GraphFactor factor);

  // Puts another factor in the place of one. Throws as AddFactor does.
  void ReplaceFactor(int index, GraphFactor factor);

  const std::vector<StateBlock>& blocks() const { return blocks_; }
  const std::vector<GraphFactor>& factors() const { return factors_; }
  const StateBlock& block(int index) const { return blocks_[static_cast<std::size_t>(index)]; }
  const GraphFactor& factor(int index) const { return factors_[static_cast<std::size_t>(index)]; }

  const Eigen::VectorXd& values() const { return values_; }
  // Throws std::invalid_argument if the size is another.
  void SetValues(const Eigen::VectorXd& values);
  double* value(int block) { return values_.data() + blocks_[block].offset; }
  const double* value(int block) const { return values_.data() + blocks_[block].offset; }

 private:
  void CheckFit(const GraphFactor& factor) const;

  std::vector<StateBlock> blocks_;
  std::vector<GraphFactor> factors_;
  Eigen::VectorXd values_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_FACTOR_GRAPH_H_
