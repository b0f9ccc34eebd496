#include "graph/block_elimination.h"

#include <Eigen/Householder>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace walkgraph {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Reflects the rows from `row` on so that `column` vanishes below `row`, and the columns after it.
void ReflectBelow(Index row, Index column, MatrixXd& front, VectorXd& workspace) {
  const Index tail = front.rows() - row - 1;
  if (tail == 0) return;
  double tau = 0;
  double beta = 0;
  front.col(column).tail(tail + 1).makeHouseholderInPlace(tau, beta);
  const Index right = front.cols() - column - 1;
  front.bottomRightCorner(tail + 1, right)
      .applyHouseholderOnTheLeft(front.col(column).tail(tail), tau, workspace.data());
  front(row, column) = beta;
  front.col(column).tail(tail).setZero();
}

// Leaves no more rows from `row` on than there are columns from `column` on.
void CompressRows(Index row, Index column, MatrixXd& front, VectorXd& workspace) {
  const Index columns = front.cols() - column;
  if (front.rows() - row <= columns) return;
  for (Index k = 0; k < columns; ++k) ReflectBelow(row + k, column + k, front, workspace);
  front.conservativeResize(row + columns, Eigen::NoChange);
}

// The elimination in progress: which factors wait for which block.
class Eliminator {
 public:
  Eliminator(const LinearSystem& system, const std::vector<int>& order,
             const std::vector<std::pair<int, int>>& pairs)
      : system_(system), scales_(ColumnNorms(system)), offsets_(ColumnOffsets(system.block_sizes)) {
    const int blocks = static_cast<int>(system.block_sizes.size());
    for (int block = 0; block < blocks; ++block) {
      position_.push_back(static_cast<int>(order.size()) + block);
    }
    for (size_t i = 0; i < order.size(); ++i) position_[order[i]] = static_cast<int>(i);
    eliminated_ = static_cast<int>(order.size());
    waiting_.resize(blocks);
    column_.resize(blocks);
    companions_.resize(blocks);
    passed_on_.resize(blocks);
    for (const LinearFactor& factor : system.factors) {
      if (!factor.blocks.empty()) waiting_[First(factor.blocks)].push_back(&factor);
    }
    for (const auto& [a, b] : pairs) {
      const int first = First({a, b});
      companions_[first].push_back(first == a ? b : a);
    }
  }

  void Eliminate(int block, BlockElimination& result) {
    BlockConditional conditional;
    conditional.block = block;
    conditional.parents = Parents(block);
    MatrixXd front = Gather(block, conditional.parents);
    const Index size = system_.block_sizes[block];
    int rank = 0;
    const std::vector<int> pivots =
        PivotedTriangularize(scales_.segment(offsets_[block], size), front, rank);
    VectorXd workspace(front.cols());
    CompressRows(rank, size, front, workspace);

    Condition(pivots, rank, front, conditional);
    for (int k = 0; k < rank; ++k) {
      result.log_determinant += 2 * std::log(std::abs(front(k, k)));
    }
    result.nullity += static_cast<int>(size) - rank;
    PassOn(conditional, front.bottomRows(front.rows() - rank).rightCols(front.cols() - size),
           result);
    result.conditionals.push_back(std::move(conditional));
  }

 private:
  int First(const std::vector<int>& blocks) const {
    return *std::min_element(blocks.begin(), blocks.end(),
                             [this](int a, int b) { return position_[a] < position_[b]; });
  }

  // The other blocks of all that waits for this one, in the order of elimination.
  std::vector<int> Parents(int block) const {
    std::vector<int> parents = companions_[block];
    for (const LinearFactor* factor : waiting_[block]) {
      parents.insert(parents.end(), factor->blocks.begin(), factor->blocks.end());
    }
    for (const LinearFactor& factor : passed_on_[block]) {
      parents.insert(parents.end(), factor.blocks.begin(), factor.blocks.end());
    }
    std::sort(parents.begin(), parents.end(),
              [this](int a, int b) { return position_[a] < position_[b]; });
    parents.erase(std::unique(parents.begin(), parents.end()), parents.end());
    std::erase(parents, block);
    return parents;
  }

  // Stacks what waits for the block: its columns, then its parents', then the residual.
  MatrixXd Gather(int block, const std::vector<int>& parents) {
    Index columns = 0;
    column_[block] = columns;
    columns += system_.block_sizes[block];
    for (const int parent : parents) {
      column_[parent] = columns;
      columns += system_.block_sizes[parent];
    }
    Index rows = 0;
    for (const LinearFactor* factor : waiting_[block]) rows += factor->residual.size();
    for (const LinearFactor& factor : passed_on_[block]) rows += factor.residual.size();
    MatrixXd front = MatrixXd::Zero(rows, columns + 1);
    Index row = 0;
    for (const LinearFactor* factor : waiting_[block]) Stack(*factor, row, front);
    for (const LinearFactor& factor : passed_on_[block]) Stack(factor, row, front);
    passed_on_[block] = {};
    return front;
  }

  void Stack(const LinearFactor& factor, Index& row, MatrixXd& front) const {
    const Index rows = factor.residual.size();
    Index from = 0;
    for (const int block : factor.blocks) {
      const Index size = system_.block_sizes[block];
      front.block(row, column_[block], rows, size) = factor.jacobian.middleCols(from, size);
      from += size;
    }
    front.col(front.cols() - 1).segment(row, rows) = factor.residual;
    row += rows;
  }

  // Solves the triangular rows of the front for the block.
  void Condition(const std::vector<int>& pivots, int rank, const MatrixXd& front,
                 BlockConditional& conditional) const {
    const Index size = static_cast<Index>(pivots.size());
    const Index width = front.cols() - size - 1;
    // Right-hand sides: identity, dependent pivots, parents, residual.
    MatrixXd solved(rank, rank + (size - rank) + width + 1);
    solved.leftCols(rank).setIdentity();
    solved.rightCols(size - rank + width + 1) =
        -front.topRows(rank).rightCols(size - rank + width + 1);
    front.topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solveInPlace(solved);

    conditional.root = MatrixXd::Zero(size, rank);
    conditional.free = MatrixXd::Zero(size, size - rank);
    conditional.regression = MatrixXd::Zero(size, width);
    conditional.mean = VectorXd::Zero(size);
    const int first_column = offsets_[conditional.block];
    for (Index k = 0; k < size; ++k) {
      const int to = pivots[k];
      if (k < rank) {
        conditional.root.row(to) = solved.row(k).head(rank);
        conditional.free.row(to) = solved.row(k).segment(rank, size - rank);
        conditional.regression.row(to) = solved.row(k).segment(size, width);
        conditional.mean(to) = solved(k, size + width);
      } else {
        conditional.free(to, k - rank) = 1;
      }
    }
    for (Index k = rank; k < size; ++k) {
      const double scale = scales_(first_column + pivots[k]);
      if (scale > 0) conditional.free.col(k - rank) /= scale;
    }
  }

  // What the block's removal leaves goes to the next of its parents, even without rows: it says
  // which blocks are coupled.
  void PassOn(const BlockConditional& conditional, const Eigen::Ref<const MatrixXd>& rows,
              BlockElimination& result) {
    const Index width = rows.cols() - 1;
    if (conditional.parents.empty()) {
      result.constant += rows.col(width).squaredNorm();
      return;
    }
    LinearFactor rest{conditional.parents, rows.leftCols(width), rows.col(width)};
    const int next = conditional.parents.front();
    if (position_[next] < eliminated_) {
      passed_on_[next].push_back(std::move(rest));
    } else {
      result.remainder.push_back(std::move(rest));
    }
  }

  const LinearSystem& system_;
  VectorXd scales_;
  std::vector<int> offsets_;
  std::vector<int> position_;  // in the order of elimination; kept blocks behind the last
  int eliminated_ = 0;
  std::vector<std::vector<const LinearFactor*>> waiting_;  // by the block that goes first
  std::vector<std::vector<LinearFactor>> passed_on_;
  std::vector<std::vector<int>> companions_;
  std::vector<Index> column_;  // of each block in the front at work
};

}  // namespace

std::vector<int> FillReducingOrder(const LinearSystem& system,
                                   const std::vector<std::pair<int, int>>& pairs) {
  const int blocks = static_cast<int>(system.block_sizes.size());
  if (blocks == 0) return {};
  std::vector<Eigen::Triplet<double>> edges;
  edges.reserve(blocks + system.factors.size());
  for (int block = 0; block < blocks; ++block) edges.emplace_back(block, block, 1);
  for (const LinearFactor& factor : system.factors) {
    for (size_t i = 0; i < factor.blocks.size(); ++i) {
      for (size_t j = 0; j < i; ++j) edges.emplace_back(factor.blocks[i], factor.blocks[j], 1);
    }
  }
  for (const auto& [a, b] : pairs) edges.emplace_back(a, b, 1);
  Eigen::SparseMatrix<double> graph(blocks, blocks);
  graph.setFromTriplets(edges.begin(), edges.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(graph, permutation);
  const auto& indices = permutation.indices();
  return {indices.data(), indices.data() + indices.size()};
}

std::vector<int> PivotedTriangularize(const VectorXd& scales, MatrixXd& front, int& rank) {
  const Index columns = scales.size();
  std::vector<int> order(columns);
  std::iota(order.begin(), order.end(), 0);
  VectorXd workspace(front.cols());
  const Index limit = std::min(columns, front.rows());
  Index k = 0;
  for (; k < limit; ++k) {
    Index pivot = k;
    double largest = 0;
    for (Index j = k; j < columns; ++j) {
      const double scale = scales(order[j]);
      if (scale == 0) continue;
      const double relative = front.col(j).tail(front.rows() - k).norm() / scale;
      if (relative > largest) {
        largest = relative;
        pivot = j;
      }
    }
    if (largest <= kRankTolerance) break;
    std::swap(order[k], order[pivot]);
    front.col(k).swap(front.col(pivot));
    ReflectBelow(k, k, front, workspace);
  }
  rank = static_cast<int>(k);
  front.block(k, k, front.rows() - k, columns - k).setZero();
  return order;
}

BlockElimination EliminateBlocks(const LinearSystem& system, const std::vector<int>& order,
                                 const std::vector<std::pair<int, int>>& pairs) {
  BlockElimination result;
  result.conditionals.reserve(order.size());
  Eliminator eliminator(system, order, pairs);
  for (const int block : order) eliminator.Eliminate(block, result);
  return result;
}

}  // namespace walkgraph
