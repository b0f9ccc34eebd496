#include "graph/sliding_window.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "graph/linearize.h"
#include "graph/marginalization.h"

namespace walkgraph {
namespace {

bool Touches(const std::vector<int>& blocks, const std::vector<bool>& is_leaving) {
  return std::any_of(blocks.begin(), blocks.end(),
                     [&](int block) { return is_leaving[static_cast<std::size_t>(block)]; });
}

// Moves what touches the leaving blocks to the end and returns where that begins.
template <typename Items, typename BlocksOf>
auto Split(Items* items, const std::vector<bool>& is_leaving, const BlocksOf& blocks_of) {
  return std::stable_partition(items->begin(), items->end(), [&](const auto& item) {
    return !Touches(blocks_of(item), is_leaving);
  });
}

}  // namespace

SlidingWindow::SlidingWindow(FactorGraph* graph)
    : graph_(graph),
      state_(graph->blocks().size(), kWaiting),
      has_first_(graph->blocks().size(), false),
      first_estimate_(graph->values()) {}

void SlidingWindow::AddBlock(int block) {
  state_[static_cast<std::size_t>(block)] = kActive;
  part_.blocks.push_back(block);
}

bool SlidingWindow::AddFactor(int factor) {
  for (const int block : graph_->factor(factor).blocks) {
    if (HasLeft(block)) return false;
  }
  part_.factors.push_back(factor);
  return true;
}

void SlidingWindow::ReplacePriors(LinearPrior prior) {
  std::fill(has_first_.begin(), has_first_.end(), false);
  Eigen::Index row = 0;
  for (const int b : prior.blocks) {
    const StateBlock& block = graph_->block(b);
    has_first_[static_cast<std::size_t>(b)] = true;
    first_estimate_.segment(block.offset, block.size()) = prior.point.segment(row, block.size());
    row += block.size();
  }
  part_.priors = {std::move(prior)};
  left_log_determinant_ = 0;
}

bool SlidingWindow::Marginalize(const std::vector<int>& leaving) {
  std::vector<bool> is_leaving(state_.size(), false);
  for (const int block : leaving) is_leaving[static_cast<std::size_t>(block)] = true;

  GraphPart next = part_;
  const auto factors = Split(
      &next.factors,
      is_leaving, [this](int factor) -> const auto& { return graph_->factor(factor).blocks; });
  const auto priors = Split(
      &next.priors, is_leaving,
      [](const LinearPrior& prior) -> const auto& { return prior.blocks; });
  const GraphPart going{{}, {factors, next.factors.end()}, {priors, next.priors.end()}};
  next.factors.erase(factors, next.factors.end());
  next.priors.erase(priors, next.priors.end());

  LinearizationPoint point{graph_->values(), graph_->values()};
  for (std::size_t b = 0; b < has_first_.size(); ++b) {
    const StateBlock& block = graph_->blocks()[b];
    if (!has_first_[b]) continue;
    point.jacobian_at->segment(block.offset, block.size()) =
        first_estimate_.segment(block.offset, block.size());
  }
  const VariableIndex index(*graph_, part_.blocks);
  LinearSystem system = Linearize(*graph_, going.factors, point, index);
  for (const LinearPrior& prior : going.priors) {
    std::vector<int> variables;
    for (const int block : prior.blocks) variables.push_back(index.variable(block));
    system.factors.push_back(AtValues(prior, *graph_, graph_->values(), variables));
  }
  std::vector<int> eliminated;
  for (const int block : leaving) {
    if (index.variable(block) >= 0) eliminated.push_back(index.variable(block));
  }
  double log_determinant = 0;
  std::optional<LinearFactor> rest = MarginalizeBlocks(system, eliminated, &log_determinant);
  if (!rest) return false;
  left_log_determinant_ += log_determinant;

  LinearPrior prior{{}, std::move(rest->jacobian), std::move(rest->residual), {}};
  prior.point.resize(prior.jacobian.cols());
  Eigen::Index row = 0;
  for (const int variable : rest->blocks) {
    const int b = index.block(variable);
    const StateBlock& block = graph_->block(b);
    prior.blocks.push_back(b);
    prior.point.segment(row, block.size()) = graph_->values().segment(block.offset, block.size());
    row += block.size();
    if (has_first_[static_cast<std::size_t>(b)]) continue;
    has_first_[static_cast<std::size_t>(b)] = true;
    first_estimate_.segment(block.offset, block.size()) =
        graph_->values().segment(block.offset, block.size());
  }
  if (!prior.blocks.empty() && !prior.empty()) next.priors.push_back(std::move(prior));
  next.blocks.erase(std::remove_if(next.blocks.begin(), next.blocks.end(),
                                   [&](int b) { return is_leaving[static_cast<std::size_t>(b)]; }),
                    next.blocks.end());
  for (const int block : leaving) state_[static_cast<std::size_t>(block)] = kLeft;
  part_ = std::move(next);
  return true;
}

}  // namespace walkgraph
