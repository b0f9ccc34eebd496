#ifndef WALKGRAPH_GRAPH_LINEAR_SYSTEM_H_
#define WALKGRAPH_GRAPH_LINEAR_SYSTEM_H_

#include <Eigen/Core>
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

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_LINEAR_SYSTEM_H_
