#include "graph/factor_graph.h"

#include <stdexcept>
#include <utility>

namespace walkgraph {

int FactorGraph::AddBlock(BlockId id, TimeNs time_ns, const Eigen::VectorXd& value, bool constant) {
  if (value.size() != BlockSize(id.kind)) {
    throw std::invalid_argument("value does not have the size of its block");
  }
  blocks_.push_back({id, time_ns, constant, static_cast<int>(values_.size())});
  values_.conservativeResize(values_.size() + value.size());
  values_.tail(value.size()) = value;
  return static_cast<int>(blocks_.size()) - 1;
}

void FactorGraph::CheckFit(const GraphFactor& factor) const {
  const std::vector<int>& sizes = factor.cost->parameter_block_sizes();
  bool fits = sizes.size() == factor.blocks.size();
  for (std::size_t i = 0; fits && i < sizes.size(); ++i) {
    const int block = factor.blocks[i];
    fits = block >= 0 && block < static_cast<int>(blocks_.size()) &&
           blocks_[static_cast<std::size_t>(block)].size() == sizes[i];
  }
  if (!fits) throw std::invalid_argument("factor " + factor.type + " does not fit its blocks");
}

int FactorGraph::AddFactor(GraphFactor factor) {
  CheckFit(factor);
  factors_.push_back(std::move(factor));
  return static_cast<int>(factors_.size()) - 1;
}

void FactorGraph::ReplaceFactor(int index, GraphFactor factor) {
  CheckFit(factor);
  factors_.at(static_cast<std::size_t>(index)) = std::move(factor);
}

void FactorGraph::SetValues(const Eigen::VectorXd& values) {
  if (values.size() != values_.size()) throw std::invalid_argument("wrong number of values");
  values_ = values;  // same size: the storage, and with it every pointer, stays
}

}  // namespace walkgraph
