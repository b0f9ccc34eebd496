#ifndef WALKGRAPH_FACTORS_COST_H_
#define WALKGRAPH_FACTORS_COST_H_

#include <ceres/autodiff_cost_function.h>
#include <ceres/sized_cost_function.h>

#include <cmath>
#include <concepts>
#include <memory>
#include <numbers>
#include <utility>

namespace walkgraph {

// A factor of fixed shape is a copyable struct with
//   static constexpr std::string_view kName;       its type in statistics and configuration
//   static constexpr int kDimension;               rows of the whitened residual
//   using Blocks = BlockSizes<...>;                sizes of the blocks, in the order of the
//   arguments template <typename T> bool operator()(const T*..., T* residual) const; double
//   LogNormaliser() const;                  of its density, see GaussianLogNormaliser
// and, where it is evaluated often, an analytic
//   bool Evaluate(const double* const* blocks, double* residual, double** jacobians) const;
// with the contract of ceres::CostFunction, of which operator() is then the twin for tests.
template <int... kSizes>
struct BlockSizes {
  static constexpr int kCount = sizeof...(kSizes);
};

template <typename Factor>
concept HasAnalyticJacobian = requires(const Factor& f, const double* const* x, double* r,
                                       double** j) {
  { f.Evaluate(x, r, j) } -> std::same_as<bool>;
};

namespace internal {

template <typename Factor, typename Blocks>
class AnalyticCost;

template <typename Factor, int... kSizes>
class AnalyticCost<Factor, BlockSizes<kSizes...>>
    : public ceres::SizedCostFunction<Factor::kDimension, kSizes...> {
 public:
  explicit AnalyticCost(Factor factor) : factor_(std::move(factor)) {}
  bool Evaluate(const double* const* blocks, double* residual, double** jacobians) const override {
    return factor_.Evaluate(blocks, residual, jacobians);
  }

 private:
  Factor factor_;
};

template <typename Factor, int... kSizes>
std::unique_ptr<ceres::CostFunction> MakeAutoDiff(Factor factor, BlockSizes<kSizes...>) {
  return std::make_unique<ceres::AutoDiffCostFunction<Factor, Factor::kDimension, kSizes...>>(
      new Factor(std::move(factor)));
}

}  // namespace internal

template <typename Factor>
std::unique_ptr<ceres::CostFunction> MakeAutoDiffCost(Factor factor) {
  return internal::MakeAutoDiff(std::move(factor), typename Factor::Blocks());
}

// The analytic Jacobian where the factor has one, automatic differentiation elsewhere.
template <typename Factor>
std::unique_ptr<ceres::CostFunction> MakeCost(Factor factor) {
  if constexpr (HasAnalyticJacobian<Factor>) {
    return std::make_unique<internal::AnalyticCost<Factor, typename Factor::Blocks>>(
        std::move(factor));
  } else {
    return MakeAutoDiffCost(std::move(factor));
  }
}

// log of sqrt(2 pi) sigma: what a Gaussian row of the residual adds to the negative log density
// beside half its square, nats.
inline double GaussianLogNormaliser(double sigma) {
  return std::log(sigma) + 0.5 * std::log(2.0 * std::numbers::pi);
}

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_COST_H_
