#include "graph/marginal_covariance.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "graph/block_elimination.h"

namespace walkgraph {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A coordinate stays put in the null space if it moves less than this fraction of what the
// coordinate that moves most does (both in their own sigmas). Squares of movements are what is
// propagated, so that rounding leaves about the square root of the machine precision.
constexpr double kMovementTolerance = 1e-6;

// Rows of the listed blocks in a front that holds them in the same order.
std::vector<Index> RowsOf(const std::vector<int>& wanted, const std::vector<int>& blocks,
                          const std::vector<int>& offsets) {
  std::vector<Index> rows;
  size_t at = 0;
  for (const int block : wanted) {
    while (blocks[at] != block) ++at;
    for (int row = offsets[at]; row < offsets[at + 1]; ++row) rows.push_back(row);
  }
  return rows;
}

// Covariance of [block; parents] from that of the parents and x_block = regression x_parents +
// noise e.
MatrixXd Extend(const MatrixXd& parents, const MatrixXd& regression, const MatrixXd& noise) {
  const Index size = regression.rows();
  const Index width = regression.cols();
  MatrixXd front(size + width, size + width);
  const MatrixXd cross = regression * parents;
  front.topRightCorner(size, width) = cross;
  front.bottomLeftCorner(width, size) = cross.transpose();
  front.bottomRightCorner(width, width) = parents;
  MatrixXd own = cross * regression.transpose();
  own.noalias() += noise * noise.transpose();
  front.topLeftCorner(size, size) = 0.5 * (own + own.transpose());
  return front;
}

// Orthonormal basis of the directions in which `divergence` (covariance per variance of the free
// variables) exceeds the threshold, with coordinates measured in sigmas.
MatrixXd DivergentDirections(const MatrixXd& divergence, const VectorXd& scale, double threshold) {
  const MatrixXd scaled = scale.asDiagonal() * divergence * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scaled);
  const Index size = scale.size();
  Index count = 0;
  while (count < size && solver.eigenvalues()(size - 1 - count) > threshold) ++count;
  if (count == 0) return MatrixXd(size, 0);
  if (count == size) return MatrixXd::Identity(size, size);
  const MatrixXd range = scale.cwiseInverse().asDiagonal() * solver.eigenvectors().rightCols(count);
  return Eigen::HouseholderQR<MatrixXd>(range).householderQ() * MatrixXd::Identity(size, count);
}

BlockMarginal Marginal(MatrixXd covariance, const MatrixXd& divergence, const VectorXd& scale,
                       double threshold) {
  const Index size = covariance.rows();
  if (divergence.size() == 0) return {std::move(covariance), MatrixXd(size, 0)};
  MatrixXd directions = DivergentDirections(divergence, scale, threshold);
  if (directions.cols() > 0) {
    const MatrixXd keep = MatrixXd::Identity(size, size) - directions * directions.transpose();
    covariance = (keep * covariance * keep).eval();
    if (directions.cols() == size) covariance.setZero();
  }
  return {std::move(covariance), std::move(directions)};
}

}  // namespace

std::optional<MarginalCovariance> MarginalCovariance::Compute(
    const LinearSystem& system, const std::vector<std::pair<int, int>>& pairs) {
  CheckShapes(system);
  CheckPairs(system, pairs);
  if (!IsFinite(system)) return std::nullopt;
  const BlockElimination elimination =
      EliminateBlocks(system, FillReducingOrder(system, pairs), pairs);

  MarginalCovariance result;
  result.nullity_ = elimination.nullity;
  result.log_determinant_ = elimination.log_determinant;
  result.column_offsets_ = ColumnOffsets(system.block_sizes);
  // A column that nothing touches is measured in its own unit.
  result.scale_ = ColumnNorms(system).unaryExpr([](double norm) { return norm > 0 ? norm : 1.0; });
  result.InvertFronts(elimination);
  result.ReadBlocks();
  return result;
}

// From the last block eliminated to the first: all parents of a block are in the front of the
// first.
void MarginalCovariance::InvertFronts(const BlockElimination& elimination) {
  const auto& conditionals = elimination.conditionals;
  fronts_.resize(conditionals.size());
  position_.resize(conditionals.size());
  for (size_t i = conditionals.size(); i-- > 0;) {
    const BlockConditional& conditional = conditionals[i];
    position_[conditional.block] = static_cast<int>(i);
    Front& front = fronts_[conditional.block];
    front.blocks.push_back(conditional.block);
    front.blocks.insert(front.blocks.end(), conditional.parents.begin(), conditional.parents.end());
    front.offsets.push_back(0);
    for (const int block : front.blocks) {
      front.offsets.push_back(front.offsets.back() + Size(block));
    }
    MatrixXd parents(0, 0);
    MatrixXd parents_divergence(0, 0);
    if (!conditional.parents.empty()) {
      const Front& next = fronts_[conditional.parents.front()];
      const std::vector<Index> rows = RowsOf(conditional.parents, next.blocks, next.offsets);
      parents = next.finite(rows, rows);
      if (next.divergence.size() > 0) parents_divergence = next.divergence(rows, rows);
    }
    front.finite = Extend(parents, conditional.regression, conditional.root);
    if (parents_divergence.size() > 0 || conditional.free.cols() > 0) {
      if (parents_divergence.size() == 0) parents_divergence = 0 * parents;
      front.divergence = Extend(parents_divergence, conditional.regression, conditional.free);
    }
  }
}

void MarginalCovariance::ReadBlocks() {
  double largest = 0;
  for (const Front& front : fronts_) {
    if (front.divergence.size() == 0) continue;
    const int block = front.blocks.front();
    const int size = Size(block);
    const VectorXd scale = scale_.segment(column_offsets_[block], size);
    largest = std::max(
        largest,
        (front.divergence.diagonal().head(size).array() * scale.array().square()).maxCoeff());
  }
  divergence_threshold_ = largest * kMovementTolerance * kMovementTolerance;

  blocks_.reserve(fronts_.size());
  for (const Front& front : fronts_) {
    const int block = front.blocks.front();
    const int size = Size(block);
    const bool bounded = front.divergence.size() == 0;
    blocks_.push_back(Marginal(front.finite.topLeftCorner(size, size),
                               bounded ? MatrixXd() : front.divergence.topLeftCorner(size, size),
                               scale_.segment(column_offsets_[block], size),
                               divergence_threshold_));
  }
}

std::optional<double> MarginalCovariance::log_determinant() const {
  if (nullity_ > 0) return std::nullopt;
  return log_determinant_;
}

std::optional<BlockMarginal> MarginalCovariance::Joint(int first, int second) const {
  const Front& front = fronts_[position_[first] < position_[second] ? first : second];
  std::vector<Index> rows;
  VectorXd scale(Size(first) + Size(second));
  for (const int block : {first, second}) {
    const auto found = std::find(front.blocks.begin(), front.blocks.end(), block);
    if (found == front.blocks.end()) return std::nullopt;
    const int offset = front.offsets[found - front.blocks.begin()];
    for (int i = 0; i < Size(block); ++i) {
      scale(static_cast<Index>(rows.size())) = scale_(column_offsets_[block] + i);
      rows.push_back(offset + i);
    }
  }
  const bool bounded = front.divergence.size() == 0;
  return Marginal(front.finite(rows, rows), bounded ? MatrixXd() : front.divergence(rows, rows),
                  scale, divergence_threshold_);
}

}  // namespace walkgraph
