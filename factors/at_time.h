#ifndef WALKGRAPH_FACTORS_AT_TIME_H_
#define WALKGRAPH_FACTORS_AT_TIME_H_

#include <ceres/cost_function.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace walkgraph {

// Evidence between two nodes: wraps a residual whose first block is a state at one time, and
// evaluates it at the state interpolated linearly between the nodes before and after,
//   x(t) = (1 - fraction) x0 + fraction x1.
// Blocks: x0, x1, then the wrapped residual's other blocks. Any cost function will do, so that no
// factor needs to know that nodes do not stand where its evidence does.
template <typename Residual = ceres::CostFunction>
class AtTime : public ceres::CostFunction {
 public:
  AtTime(double fraction, std::unique_ptr<Residual> residual)
      : fraction_(fraction), residual_(std::move(residual)) {
    const std::vector<int>& sizes = residual_->parameter_block_sizes();
    set_num_residuals(residual_->num_residuals());
    mutable_parameter_block_sizes()->push_back(sizes.front());
    mutable_parameter_block_sizes()->insert(mutable_parameter_block_sizes()->end(), sizes.begin(),
                                            sizes.end());
  }

  bool Evaluate(const double* const* blocks, double* residual, double** jacobians) const override {
    const int size = parameter_block_sizes().front();
    std::vector<double> state(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) {
      state[i] = (1.0 - fraction_) * blocks[0][i] + fraction_ * blocks[1][i];
    }
    std::vector<const double*> inner_blocks(blocks + 1, blocks + parameter_block_sizes().size());
    inner_blocks[0] = state.data();
    if (jacobians == nullptr) return residual_->Evaluate(inner_blocks.data(), residual, nullptr);

    std::vector<double*> inner(jacobians + 1, jacobians + parameter_block_sizes().size());
    std::vector<double> by_state(static_cast<std::size_t>(num_residuals() * size));
    inner[0] = jacobians[0] != nullptr || jacobians[1] != nullptr ? by_state.data() : nullptr;
    if (!residual_->Evaluate(inner_blocks.data(), residual, inner.data())) return false;
    Scale(by_state, 1.0 - fraction_, jacobians[0]);
    Scale(by_state, fraction_, jacobians[1]);
    return true;
  }

 private:
  static void Scale(const std::vector<double>& from, double factor, double* to) {
    if (to == nullptr) return;
    std::transform(from.begin(), from.end(), to, [factor](double value) { return factor * value; });
  }

  double fraction_;
  std::unique_ptr<Residual> residual_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_AT_TIME_H_
