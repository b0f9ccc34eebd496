#include "graph/marginalization.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "graph/block_elimination.h"

namespace walkgraph {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<char> Membership(const LinearSystem& system, const std::vector<int>& eliminated) {
  std::vector<char> member(system.block_sizes.size(), 0);
  for (const int block : eliminated) {
    if (block < 0 || block >= static_cast<int>(member.size()) || member[block] != 0) {
      throw std::invalid_argument("cannot eliminate block " + std::to_string(block) +
                                  ": expected indices in range, each once");
    }
    member[block] = 1;
  }
  return member;
}

LinearSystem Involved(const LinearSystem& system, const std::vector<char>& eliminated) {
  LinearSystem involved{system.block_sizes, {}};
  for (const LinearFactor& factor : system.factors) {
    if (std::any_of(factor.blocks.begin(), factor.blocks.end(),
                    [&](int block) { return eliminated[block] != 0; })) {
      involved.factors.push_back(factor);
    }
  }
  return involved;
}

// The blocks of the factors, ascending.
std::vector<int> Union(const std::vector<LinearFactor>& factors) {
  std::vector<int> blocks;
  for (const LinearFactor& factor : factors) {
    blocks.insert(blocks.end(), factor.blocks.begin(), factor.blocks.end());
  }
  std::sort(blocks.begin(), blocks.end());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  return blocks;
}

// All rows over the columns of `blocks`, the residual behind them.
MatrixXd StackRows(const std::vector<LinearFactor>& factors, const std::vector<int>& blocks,
                   const std::vector<int>& sizes, Index columns) {
  Index rows = 0;
  for (const LinearFactor& factor : factors) rows += factor.residual.size();
  MatrixXd stacked = MatrixXd::Zero(rows, columns + 1);
  std::vector<Index> column(sizes.size(), 0);
  Index next = 0;
  for (const int block : blocks) {
    column[block] = next;
    next += sizes[block];
  }
  Index row = 0;
  for (const LinearFactor& factor : factors) {
    const Index height = factor.residual.size();
    Index from = 0;
    for (const int block : factor.blocks) {
      stacked.block(row, column[block], height, sizes[block]) =
          factor.jacobian.middleCols(from, sizes[block]);
      from += sizes[block];
    }
    stacked.col(columns).segment(row, height) = factor.residual;
    row += height;
  }
  return stacked;
}

}  // namespace

std::optional<LinearFactor> MarginalizeBlocks(const LinearSystem& system,
                                              const std::vector<int>& eliminated,
                                              double* log_determinant) {
  CheckShapes(system);
  const std::vector<char> member = Membership(system, eliminated);
  const LinearSystem involved = Involved(system, member);
  if (!IsFinite(involved)) return std::nullopt;

  std::vector<int> order = FillReducingOrder(involved);
  std::erase_if(order, [&](int block) { return member[block] == 0; });
  const BlockElimination elimination = EliminateBlocks(involved, order);
  if (log_determinant != nullptr) *log_determinant = elimination.log_determinant;

  LinearFactor prior;
  prior.blocks = Union(elimination.remainder);
  const std::vector<int> offsets = ColumnOffsets(system.block_sizes);
  const VectorXd norms = ColumnNorms(involved);
  VectorXd scales(0);
  for (const int block : prior.blocks) {
    const Index size = system.block_sizes[block];
    scales.conservativeResize(scales.size() + size);
    scales.tail(size) = norms.segment(offsets[block], size);
  }
  const Index columns = scales.size();
  MatrixXd rows = StackRows(elimination.remainder, prior.blocks, system.block_sizes, columns);
  int rank = 0;
  const std::vector<int> pivots = PivotedTriangularize(scales, rows, rank);

  // What no column explains is one more row, without a Jacobian.
  const double constant =
      elimination.constant + rows.col(columns).tail(rows.rows() - rank).squaredNorm();
  const Index height = rank + (constant > 0 ? 1 : 0);
  prior.jacobian = MatrixXd::Zero(height, columns);
  prior.residual.resize(height);
  for (Index k = 0; k < columns; ++k) {
    prior.jacobian.col(pivots[k]).head(rank) = rows.col(k).head(rank);
  }
  prior.residual.head(rank) = rows.col(columns).head(rank);
  if (constant > 0) prior.residual(rank) = std::sqrt(constant);
  return prior;
}

}  // namespace walkgraph
