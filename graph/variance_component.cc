#include "graph/variance_component.h"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/SpecialFunctions>

namespace walkgraph {
namespace {

bool IsOfGroup(const LinearFactor& factor, const std::vector<bool>& in_group) {
  return std::all_of(factor.blocks.begin(), factor.blocks.end(),
                     [&in_group](int block) { return in_group[static_cast<std::size_t>(block)]; });
}

// Joint covariance of a factor's blocks, in their order. Precondition: one block or two.
Eigen::MatrixXd CovarianceOf(const LinearFactor& factor, const MarginalCovariance& marginals) {
  if (factor.blocks.size() == 1) return marginals.block(factor.blocks.front()).covariance;
  return marginals.Joint(factor.blocks[0], factor.blocks[1])->covariance;
}

}  // namespace

double VarianceComponent::Inflation(double level) const {
  if (!(redundancy >= 1.0)) return 1.0;
  const double exceeded_by_chance = Eigen::numext::igammac(0.5 * redundancy, 0.5 * squares);
  return squares > redundancy && exceeded_by_chance < level ? squares / redundancy : 1.0;
}

VarianceComponent EstimateVarianceComponent(const LinearSystem& system,
                                            const std::vector<bool>& in_group,
                                            const MarginalCovariance& marginals) {
  VarianceComponent component;
  for (const LinearFactor& factor : system.factors) {
    // Priors on more blocks come from a window's past, whose residuals were counted there.
    if (factor.blocks.size() > 2 || !IsOfGroup(factor, in_group)) continue;
    const Eigen::MatrixXd& jacobian = factor.jacobian;
    const double used = (jacobian * CovarianceOf(factor, marginals)).cwiseProduct(jacobian).sum();
    component.squares += factor.residual.squaredNorm();
    component.redundancy += static_cast<double>(factor.residual.size()) - used;
  }
  return component;
}

void InflateVariance(double factor, const std::vector<bool>& in_group, LinearSystem* system) {
  const double scale = 1.0 / std::sqrt(factor);
  for (LinearFactor& linear : system->factors) {
    if (linear.blocks.size() > 2 || !IsOfGroup(linear, in_group)) continue;
    linear.jacobian *= scale;
    linear.residual *= scale;
  }
}

}  // namespace walkgraph
