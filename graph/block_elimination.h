#ifndef WALKGRAPH_GRAPH_BLOCK_ELIMINATION_H_
#define WALKGRAPH_GRAPH_BLOCK_ELIMINATION_H_

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "graph/linear_system.h"

namespace walkgraph {

// A column counts as dependent on others if what elimination leaves of it is at most this fraction
// of its norm. Rounding leaves under 1e-14 on a chain of 30,000 nodes, and a state known a
// million times worse than its neighbours still stands a thousand times above it.
inline constexpr double kRankTolerance = 1e-9;

// A block given the blocks it was conditioned on:
//   x_block = mean + regression x_parents + root e + free f
// with e standard normal and f anything at all. `root` has a column per observable direction of the
// block (given the parents), `free` one per other direction, which moves one coordinate of the
// block by its sigma with all else known.
struct BlockConditional {
  int block = 0;
  std::vector<int> parents;  // eliminated later in the order that they have here, or never
  Eigen::VectorXd mean;
  Eigen::MatrixXd regression;  // size x sum of the parents' sizes
  Eigen::MatrixXd root;        // size x rank
  Eigen::MatrixXd free;        // size x (size - rank)
};

// The blocks of a linear system removed one after the other by Householder QR.
struct BlockElimination {
  std::vector<BlockConditional> conditionals;  // in the order of elimination
  std::vector<LinearFactor> remainder;         // on blocks that were not eliminated
  double constant = 0;                         // sum of squared residuals that no block can explain
  double log_determinant = 0;  // of J^T J without the rows and columns of dependent pivots
  int nullity = 0;             // number of dependent pivots
};

// All blocks in an order of little fill (approximate minimum degree on the blocks' graph, to which
// `pairs` add edges).
std::vector<int> FillReducingOrder(const LinearSystem& system,
                                   const std::vector<std::pair<int, int>>& pairs = {});

// Eliminates the blocks of `order`. `pairs` are kept together as if a factor joined them. The
// system must have passed CheckShapes and IsFinite.
BlockElimination EliminateBlocks(const LinearSystem& system, const std::vector<int>& order,
                                 const std::vector<std::pair<int, int>>& pairs = {});

// Brings the first columns of `front` to upper trapezoidal form by Householder reflections from the
// left, pivoting among the first scales.size() columns by norm relative to `scales`, and stops at
// the first pivot within kRankTolerance, clearing what is left of those columns. Returns the order
// of the columns, pivots first; `rank` is how many pivots there are.
std::vector<int> PivotedTriangularize(const Eigen::VectorXd& scales, Eigen::MatrixXd& front,
                                      int& rank);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_BLOCK_ELIMINATION_H_
