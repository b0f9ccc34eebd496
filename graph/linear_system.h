#ifndef WALKGRAPH_GRAPH_LINEAR_SYSTEM_H_
#define WALKGRAPH_GRAPH_LINEAR_SYSTEM_H_

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace walkgraph {

// One factor linearised: residual(x + d) = residual + jacobian d, already whitened and, under a
// robust loss, scaled by its converged weight.
struct LinearFactor {
  std::vector<int> blocks;   // indices of the blocks it touches, each once
  Eigen::MatrixXd jacobian;  // rows x sum of their sizes, columns in the order of `blocks`
  Eigen::VectorXd residual;
};

// A whole problem linearised at one point: sum over factors of 1/2 |residual + jacobian d|^2.
struct LinearSystem {
  std::vector<int> block_sizes;
  std::vector<LinearFactor> factors;
};

// Throws std::invalid_argument unless sizes are positive, every factor has a Jacobian of the right
// width and as many residuals as rows, and block indices are in range and unrepeated.
void CheckShapes(const LinearSystem& system);
// Throws std::invalid_argument unless each pair names two different blocks of the system.
void CheckPairs(const LinearSystem& system, const std::vector<std::pair<int, int>>& pairs);

bool IsFinite(const LinearSystem& system);

// First column of each block, and the total at the end: one entry more than blocks.
std::vector<int> ColumnOffsets(const std::vector<int>& block_sizes);

// Norm of each column of the stacked Jacobian.
Eigen::VectorXd ColumnNorms(const LinearSystem& system);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_LINEAR_SYSTEM_H_
