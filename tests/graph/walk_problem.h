#ifndef WALKGRAPH_TESTS_GRAPH_WALK_PROBLEM_H_
#define WALKGRAPH_TESTS_GRAPH_WALK_PROBLEM_H_

#include <cmath>
#include <vector>

#include "graph/linear_problems.h"
#include "graph/linear_system.h"

namespace walkgraph {

// A walk linearised on a winding path: per node a position [2] and a heading [1], slow states (the
// gyroscope's bias and a map error [2]) on knots, and one global step scale.
struct WalkProblem {
  int nodes = 0;
  int nodes_per_knot = 0;
  std::vector<int> position;  // block of each node
  std::vector<int> heading;
  std::vector<int> bias;  // block of each knot
  std::vector<int> map_error;
  int step_scale = 0;
  LinearSystem system;
};

struct WalkOptions {
  int nodes = 100;
  int nodes_per_knot = 40;  // 20 s at two steps a second
  bool positions = true;    // a position measurement at every fourth node
  bool headings = true;     // an absolute heading at every node
};

inline WalkProblem MakeWalk(const WalkOptions& options) {
  using Eigen::MatrixXd;
  using Eigen::VectorXd;
  constexpr double kStepM = 0.7;
  WalkProblem walk{options.nodes, options.nodes_per_knot, {}, {}, {}, {}, 0, {}};
  std::vector<int>& sizes = walk.system.block_sizes;
  const auto add_block = [&sizes](int size) {
    sizes.push_back(size);
    return static_cast<int>(sizes.size()) - 1;
  };
  for (int i = 0; i < options.nodes; ++i) {
    walk.position.push_back(add_block(2));
    walk.heading.push_back(add_block(1));
    if (i % options.nodes_per_knot == 0) {
      walk.bias.push_back(add_block(1));
      walk.map_error.push_back(add_block(2));
    }
  }
  walk.step_scale = add_block(1);

  LinearSystem& system = walk.system;
  const MatrixXd one = MatrixXd::Identity(1, 1);
  const MatrixXd two = MatrixXd::Identity(2, 2);
  const auto residual = [](int rows, int i) -> VectorXd {
    return VectorXd::LinSpaced(rows, 0.3, 0.9) * std::sin(1.7 * i);
  };
  AddFactor({walk.step_scale}, {one / 0.1}, residual(1, 3), system);
  AddFactor({walk.bias[0]}, {one / 0.01}, residual(1, 4), system);
  AddFactor({walk.map_error[0]}, {two / 2.0}, residual(2, 5), system);
  for (size_t k = 1; k < walk.bias.size(); ++k) {
    const int seed = static_cast<int>(k);
    AddFactor({walk.bias[k - 1], walk.bias[k]}, {-one / 0.002, one / 0.002}, residual(1, seed),
              system);
    AddFactor({walk.map_error[k - 1], walk.map_error[k]}, {-two / 1.5, two / 1.5},
              residual(2, seed), system);
  }
  for (int i = 0; i < options.nodes; ++i) {
    const double heading_rad = 0.002 * i + std::sin(0.05 * i);
    const int knot = i / options.nodes_per_knot;
    if (i + 1 < options.nodes) {
      const Eigen::Vector2d along(std::cos(heading_rad), std::sin(heading_rad));
      const Eigen::Vector2d left(-along.y(), along.x());
      AddFactor({walk.position[i], walk.position[i + 1], walk.heading[i], walk.step_scale},
                {-two / 0.1, two / 0.1, -kStepM / 0.1 * left, -kStepM / 0.1 * along},
                residual(2, i), system);
      AddFactor({walk.heading[i], walk.heading[i + 1], walk.bias[knot]},
                {-one / 0.02, one / 0.02, -0.5 * one / 0.02}, residual(1, i), system);
    }
    if (options.positions && i % 4 == 0) {
      AddFactor({walk.position[i], walk.map_error[knot]}, {two / 3.0, two / 3.0}, residual(2, i),
                system);
    }
    if (options.headings) {
      AddFactor({walk.heading[i]}, {one / 0.4}, residual(1, i), system);
    }
  }
  return walk;
}

}  // namespace walkgraph

#endif  // WALKGRAPH_TESTS_GRAPH_WALK_PROBLEM_H_
