#ifndef WALKGRAPH_TESTS_GRAPH_LINEAR_PROBLEMS_H_
#define WALKGRAPH_TESTS_GRAPH_LINEAR_PROBLEMS_H_

#include <Eigen/Core>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "graph/linear_system.h"

namespace walkgraph {

// Adds a factor on blocks whose Jacobians are given in the same order.
inline void AddFactor(const std::vector<int>& blocks, const std::vector<Eigen::MatrixXd>& jacobians,
                      const Eigen::VectorXd& residual, LinearSystem& system) {
  LinearFactor factor{blocks, Eigen::MatrixXd(residual.size(), 0), residual};
  for (const Eigen::MatrixXd& jacobian : jacobians) {
    factor.jacobian.conservativeResize(Eigen::NoChange, factor.jacobian.cols() + jacobian.cols());
    factor.jacobian.rightCols(jacobian.cols()) = jacobian;
  }
  system.factors.push_back(std::move(factor));
}

// The stacked Jacobian and residual of the whole system.
struct DenseSystem {
  Eigen::MatrixXd jacobian;
  Eigen::VectorXd residual;
};

inline DenseSystem ToDense(const LinearSystem& system) {
  const std::vector<int> offsets = ColumnOffsets(system.block_sizes);
  Eigen::Index rows = 0;
  for (const LinearFactor& factor : system.factors) rows += factor.residual.size();
  DenseSystem dense{Eigen::MatrixXd::Zero(rows, offsets.back()), Eigen::VectorXd(rows)};
  Eigen::Index row = 0;
  for (const LinearFactor& factor : system.factors) {
    const Eigen::Index height = factor.residual.size();
    Eigen::Index from = 0;
    for (const int block : factor.blocks) {
      const int size = system.block_sizes[block];
      dense.jacobian.block(row, offsets[block], height, size) =
          factor.jacobian.middleCols(from, size);
      from += size;
    }
    dense.residual.segment(row, height) = factor.residual;
    row += height;
  }
  return dense;
}

class RandomProblems {
 public:
  explicit RandomProblems(unsigned seed) : generator_(seed) {}

  Eigen::MatrixXd Matrix(int rows, int columns) {
    std::normal_distribution<double> normal;
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator_); });
  }
  int Integer(int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(generator_);
  }
  double Uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }

  // Blocks of 1 to 3 coordinates, a prior on each and factors between some; the priors' weights
  // reach down to `weakest`, which sets the condition number of the Jacobian to about its inverse.
  LinearSystem Connected(int blocks, double weakest) {
    LinearSystem system;
    for (int i = 0; i < blocks; ++i) system.block_sizes.push_back(Integer(1, 3));
    for (int i = 0; i < blocks; ++i) {
      const int size = system.block_sizes[i];
      const double weight = std::pow(weakest, Uniform(0, 1));
      AddFactor({i}, {weight * Matrix(size, size)}, Matrix(size, 1), system);
    }
    for (int i = 0; i + 1 < blocks; ++i) {
      const int far = Integer(0, blocks - 1);
      std::vector<int> touched{i, i + 1};
      if (far != i && far != i + 1) touched.push_back(far);
      std::vector<Eigen::MatrixXd> jacobians;
      for (const int block : touched) jacobians.push_back(Matrix(2, system.block_sizes[block]));
      AddFactor(touched, jacobians, Matrix(2, 1), system);
    }
    return system;
  }

 private:
  std::mt19937 generator_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_TESTS_GRAPH_LINEAR_PROBLEMS_H_
