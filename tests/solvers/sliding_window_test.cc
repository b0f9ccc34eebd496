#include "graph/sliding_window.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "factors/absolute_heading.h"
#include "factors/heading_increment.h"
#include "factors/prior.h"
#include "factors/step.h"
#include "graph/linearize.h"
#include "graph/marginal_covariance.h"
#include "solvers/graph_solver.h"

namespace walkgraph {
namespace {

// r = sum_i J_i x_i - b.
class LinearCost : public ceres::CostFunction {
 public:
  LinearCost(std::vector<Eigen::MatrixXd> jacobians, Eigen::VectorXd target)
      : jacobians_(std::move(jacobians)), target_(std::move(target)) {
    set_num_residuals(static_cast<int>(target_.size()));
    for (const auto& j : jacobians_) {
      mutable_parameter_block_sizes()->push_back(static_cast<int>(j.cols()));
    }
  }
  bool Evaluate(const double* const* x, double* residual, double** jacobians) const override {
    Eigen::Map<Eigen::VectorXd> r(residual, num_residuals());
    r = -target_;
    for (std::size_t i = 0; i < jacobians_.size(); ++i) {
      const Eigen::MatrixXd& j = jacobians_[i];
      r += j * Eigen::Map<const Eigen::VectorXd>(x[i], j.cols());
      if (jacobians == nullptr || jacobians[i] == nullptr) continue;
      for (Eigen::Index row = 0; row < j.rows(); ++row) {
        for (Eigen::Index col = 0; col < j.cols(); ++col) {
          jacobians[i][row * j.cols() + col] = j(row, col);
        }
      }
    }
    return true;
  }

 private:
  std::vector<Eigen::MatrixXd> jacobians_;
  Eigen::VectorXd target_;
};

// Far beyond what a walk needs: these tests compare digits.
SolverSettings Exact() {
  SolverSettings settings;
  settings.tolerance_nats = 0;
  return settings;
}

struct Belief {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
};

Belief WindowBelief(const FactorGraph& graph, const SlidingWindow& window, int block) {
  const VariableIndex index(graph, window.part().blocks);
  const auto marginals = MarginalCovariance::Compute(Linearize(graph, window.part(), index));
  const StateBlock& state = graph.block(block);
  return {graph.values().segment(state.offset, state.size()),
          marginals->block(index.variable(block)).covariance};
}

// A second way to the same answer: all factors among the blocks so far, stacked densely, by
// column-pivoted QR at the given point.
class DenseBatch {
 public:
  DenseBatch(const FactorGraph& graph, const std::vector<int>& blocks,
             const std::vector<int>& factors, const Eigen::VectorXd& values)
      : graph_(graph), index_(graph, blocks) {
    const LinearSystem system = Linearize(graph, factors, {values, std::nullopt}, index_);
    for (int v = 0; v < index_.size(); ++v) {
      column_.push_back(columns_);
      columns_ += system.block_sizes[static_cast<std::size_t>(v)];
    }
    Eigen::Index rows = 0;
    for (const LinearFactor& factor : system.factors) rows += factor.residual.size();
    jacobian_ = Eigen::MatrixXd::Zero(rows, columns_);
    Eigen::VectorXd residual(rows);
    Eigen::Index row = 0;
    for (const LinearFactor& factor : system.factors) {
      Eigen::Index col = 0;
      for (const int v : factor.blocks) {
        const int size = system.block_sizes[static_cast<std::size_t>(v)];
        jacobian_.block(row, column_[static_cast<std::size_t>(v)], factor.residual.size(), size) =
            factor.jacobian.middleCols(col, size);
        col += size;
      }
      residual.segment(row, factor.residual.size()) = factor.residual;
      row += factor.residual.size();
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(jacobian_);
    step_ = qr.solve(-residual);
    const Eigen::MatrixXd r = qr.matrixR().topRows(columns_).triangularView<Eigen::Upper>();
    const Eigen::MatrixXd root =
        qr.colsPermutation() *
        r.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(columns_, columns_));
    covariance_ = root * root.transpose();
    values_ = values;
  }

  Belief Of(int block) const {
    const StateBlock& state = graph_.block(block);
    const Eigen::Index at = column_[static_cast<std::size_t>(index_.variable(block))];
    return {values_.segment(state.offset, state.size()) + step_.segment(at, state.size()),
            covariance_.block(at, at, state.size(), state.size())};
  }
  double ConditionOfHessian() const {
    const Eigen::VectorXd singular = jacobian_.jacobiSvd().singularValues();
    return std::pow(singular[0] / singular[singular.size() - 1], 2);
  }

 private:
  const FactorGraph& graph_;
  VariableIndex index_;
  std::vector<Eigen::Index> column_;
  Eigen::Index columns_ = 0;
  Eigen::MatrixXd jacobian_;
  Eigen::VectorXd step_, values_;
  Eigen::MatrixXd covariance_;
};

void ExpectEqual(const Belief& window, const Belief& batch, double relative, std::size_t update) {
  EXPECT_LT((window.mean - batch.mean).norm(), relative * (1 + batch.mean.norm()))
      << "update " << update;
  EXPECT_LT((window.covariance - batch.covariance).norm(), relative * batch.covariance.norm())
      << "update " << update;
}

// A chain of positions and headings with one gyroscope bias per ten nodes. `arrivals[i]` are the
// factors whose last node is i.
struct Chain {
  FactorGraph graph;
  std::vector<int> position, heading, bias;
  std::vector<std::vector<int>> arrivals;
};

constexpr std::size_t kNodesPerBias = 10;

Chain MakeChain(std::size_t nodes) {
  Chain chain;
  for (std::size_t i = 0; i < nodes; ++i) {
    const int n = static_cast<int>(i);
    chain.position.push_back(
        chain.graph.AddBlock({BlockKind::kPosition, n}, n, Eigen::Vector2d::Zero()));
    chain.heading.push_back(
        chain.graph.AddBlock({BlockKind::kHeading, n}, n, Eigen::VectorXd::Zero(1)));
    if (i % kNodesPerBias == 0) {
      chain.bias.push_back(
          chain.graph.AddBlock({BlockKind::kGyroBias, n}, n, Eigen::VectorXd::Zero(1)));
    }
  }
  chain.arrivals.resize(nodes);
  return chain;
}

GraphFactor MakeLinear(std::vector<int> blocks, std::vector<Eigen::MatrixXd> jacobians,
                       const Eigen::VectorXd& target) {
  GraphFactor factor;
  factor.type = "linear";
  factor.blocks = std::move(blocks);
  factor.cost = std::make_unique<LinearCost>(std::move(jacobians), target);
  return factor;
}

// Random linear factors along the chain; `precision` is how much sharper relative ones are than
// absolute ones, which sets the condition number.
Chain MakeLinearChain(std::size_t nodes, double precision, std::mt19937* random) {
  std::normal_distribution<double> normal;
  const auto matrix = [&](int rows, int cols) {
    return Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return normal(*random); }).eval();
  };
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 1), two = Eigen::MatrixXd::Identity(2, 2);
  Chain chain = MakeChain(nodes);
  const auto add = [&](std::size_t at, GraphFactor factor) {
    chain.arrivals[at].push_back(chain.graph.AddFactor(std::move(factor)));
  };
  add(0, MakeLinear({chain.position[0]}, {two}, matrix(2, 1)));
  add(0, MakeLinear({chain.heading[0]}, {one}, matrix(1, 1)));
  add(0, MakeLinear({chain.bias[0]}, {one}, matrix(1, 1)));
  for (std::size_t i = 1; i < nodes; ++i) {
    const int bias = chain.bias[i / kNodesPerBias];
    add(i, MakeLinear({chain.position[i - 1], chain.position[i], chain.heading[i]},
                      {-precision * two, precision * two, 0.1 * precision * matrix(2, 1)},
                      precision * matrix(2, 1)));
    add(i, MakeLinear({chain.heading[i - 1], chain.heading[i], bias},
                      {-precision * one, precision * one, 0.5 * one}, matrix(1, 1)));
    if (i % 4 == 0) add(i, MakeLinear({chain.position[i]}, {matrix(2, 2)}, matrix(2, 1)));
    if (i % kNodesPerBias == 0) {
      add(i, MakeLinear({chain.bias[i / kNodesPerBias - 1], bias}, {-one, one}, matrix(1, 1)));
    }
  }
  return chain;
}

// Plays node i into the window.
void Arrive(const Chain& chain, std::size_t i, SlidingWindow* window) {
  window->AddBlock(chain.position[i]);
  window->AddBlock(chain.heading[i]);
  if (i % kNodesPerBias == 0) window->AddBlock(chain.bias[i / kNodesPerBias]);
  for (const int factor : chain.arrivals[i]) EXPECT_TRUE(window->AddFactor(factor));
}

// Removes node i - length, and a bias when the window is past it.
void Leave(const Chain& chain, std::size_t i, std::size_t length, SlidingWindow* window) {
  if (i < length) return;
  std::vector<int> leaving = {chain.position[i - length], chain.heading[i - length]};
  const std::size_t knot = (i - length) / kNodesPerBias;
  if ((i - length) % kNodesPerBias == kNodesPerBias - 1) leaving.push_back(chain.bias[knot]);
  ASSERT_TRUE(window->Marginalize(leaving));
}

struct UpTo {
  std::vector<int> blocks, factors;
};
UpTo BatchPart(const Chain& chain, std::size_t last) {
  UpTo part;
  for (std::size_t i = 0; i <= last; ++i) {
    part.blocks.push_back(chain.position[i]);
    part.blocks.push_back(chain.heading[i]);
    if (i % kNodesPerBias == 0) part.blocks.push_back(chain.bias[i / kNodesPerBias]);
    part.factors.insert(part.factors.end(), chain.arrivals[i].begin(), chain.arrivals[i].end());
  }
  return part;
}

TEST(SlidingWindowTest, EqualsBatchOnLinearProblemsAfterEveryUpdate) {
  std::mt19937 random(1);
  for (const double precision : {1.0, 10.0, 150.0}) {
    Chain chain = MakeLinearChain(60, precision, &random);
    SlidingWindow window(&chain.graph);
    double condition = 0;
    for (std::size_t i = 0; i < chain.position.size(); ++i) {
      Arrive(chain, i, &window);
      ASSERT_TRUE(SolveGraph(window.part(), Exact(), &chain.graph).ok);
      PolishSolution(window.part(), &chain.graph);
      const UpTo all = BatchPart(chain, i);
      const DenseBatch batch(chain.graph, all.blocks, all.factors,
                             Eigen::VectorXd::Zero(chain.graph.values().size()));
      for (const int block : {chain.position[i], chain.heading[i]}) {
        ExpectEqual(WindowBelief(chain.graph, window, block), batch.Of(block), 1e-9, i);
      }
      condition = batch.ConditionOfHessian();
      Leave(chain, i, 7, &window);
    }
    if (precision > 100) {
      EXPECT_GT(condition, 1e6);  // the test is as hard as it claims
    }
  }
}

// Steps, turns, compass and tags of an exact walk: whoever linearises does so at the truth.
TEST(SlidingWindowTest, EqualsBatchOnNonlinearProblemsLinearisedAtOnePoint) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  constexpr std::size_t kNodes = 80;
  Chain chain = MakeChain(kNodes);
  const int scale = chain.graph.AddBlock({BlockKind::kStepScale, 0}, 0, Eigen::VectorXd::Ones(1));
  std::vector<Eigen::Vector2d> p = {{3, 4}};
  std::vector<double> h = {1.0};
  const auto add = [&](std::size_t at, GraphFactor factor) {
    chain.arrivals[at].push_back(chain.graph.AddFactor(std::move(factor)));
  };
  add(0, MakeGraphFactor(PositionAnchorFactor{p[0].x(), p[0].y(), 1.0}, {chain.position[0]}));
  add(0, MakeGraphFactor(StatePriorFactor{1.05, 0.1}, {scale}));
  add(0,
      MakeGraphFactor(AbsoluteHeadingFactor{h[0] - 0.02, 0.2}, {chain.heading[0], chain.bias[0]}));
  add(0, MakeGraphFactor(StatePriorFactor{0.02, 0.1}, {chain.bias[0]}));
  for (std::size_t i = 1; i < kNodes; ++i) {
    const int bias = chain.bias[i / kNodesPerBias];
    h.push_back(h.back() + 0.3 * normal(random));
    const StepFactor step{0.7, 0.1, 0.08};
    p.push_back(step.Predict(p.back(), h[i - 1], h[i], 1.05));
    add(i, MakeGraphFactor(step, {chain.position[i - 1], chain.heading[i - 1], chain.position[i],
                                  chain.heading[i], scale}));
    add(i, MakeGraphFactor(HeadingIncrementFactor{h[i] - h[i - 1] + 0.02 * 0.5, 0.5, 0.03},
                           {chain.heading[i - 1], chain.heading[i], bias}));
    if (i % kNodesPerBias == 0) {
      add(i, MakeGraphFactor(StatePriorFactor{0.02, 0.1}, {bias}));
      add(i, MakeGraphFactor(PositionAnchorFactor{p[i].x(), p[i].y(), 2.0}, {chain.position[i]}));
    }
  }
  SlidingWindow window(&chain.graph);
  window.AddBlock(scale);
  Eigen::VectorXd truth = chain.graph.values();
  truth[chain.graph.block(scale).offset] = 1.05;
  for (const int b : chain.bias) truth[chain.graph.block(b).offset] = 0.02;
  for (std::size_t i = 0; i < kNodes; ++i) {
    truth.segment<2>(chain.graph.block(chain.position[i]).offset) = p[i];
    truth[chain.graph.block(chain.heading[i]).offset] = h[i];
    // Starts off the truth, so that the solver has something to find.
    chain.graph.value(chain.position[i])[0] = p[i].x() + 0.3 * normal(random);
    chain.graph.value(chain.position[i])[1] = p[i].y() + 0.3 * normal(random);
    *chain.graph.value(chain.heading[i]) = h[i] + 0.2 * normal(random);
    Arrive(chain, i, &window);
    ASSERT_TRUE(SolveGraph(window.part(), Exact(), &chain.graph).ok);
    UpTo all = BatchPart(chain, i);
    all.blocks.push_back(scale);
    const DenseBatch batch(chain.graph, all.blocks, all.factors, truth);
    for (const int block : {chain.position[i], chain.heading[i], scale}) {
      ExpectEqual(WindowBelief(chain.graph, window, block), batch.Of(block), 1e-8, i);
    }
    Leave(chain, i, 8, &window);
  }
}

// A dead-reckoned walk can be moved and turned as a whole. Contradicting evidence moves the
// estimates between marginalisations, which is when a prior with Jacobians at the latest values
// would begin to believe in a direction.
TEST(SlidingWindowTest, LearnsNothingAboutUnobservableDirectionsInAThousandMarginalisations) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  constexpr std::size_t kNodes = 1012, kLength = 10;
  FactorGraph graph;
  std::vector<int> position, heading;
  for (std::size_t i = 0; i < kNodes; ++i) {
    const int n = static_cast<int>(i);
    position.push_back(graph.AddBlock({BlockKind::kPosition, n}, n, Eigen::Vector2d::Zero()));
    heading.push_back(graph.AddBlock({BlockKind::kHeading, n}, n, Eigen::VectorXd::Zero(1)));
  }
  const int scale = graph.AddBlock({BlockKind::kStepScale, 0}, 0, Eigen::VectorXd::Ones(1), true);
  const int bias = graph.AddBlock({BlockKind::kGyroBias, 0}, 0, Eigen::VectorXd::Zero(1), true);
  std::vector<std::vector<int>> arrivals(kNodes);
  for (std::size_t i = 1; i < kNodes; ++i) {
    for (const std::size_t back : {std::size_t{1}, std::size_t{4}}) {
      if (i < back) continue;
      const double steps = static_cast<double>(back);
      arrivals[i].push_back(graph.AddFactor(MakeGraphFactor(
          StepFactor{0.7 * steps * (1 + 0.1 * normal(random)), 0.1, 0.1},
          {position[i - back], heading[i - back], position[i], heading[i], scale})));
      arrivals[i].push_back(graph.AddFactor(
          MakeGraphFactor(HeadingIncrementFactor{0.1 * steps * normal(random), 0.5, 0.05},
                          {heading[i - back], heading[i], bias})));
    }
  }
  SlidingWindow window(&graph);
  Eigen::VectorXd first = graph.values();
  std::vector<bool> touched(graph.blocks().size(), false);
  for (std::size_t i = 0; i < kNodes; ++i) {
    if (i > 0) {
      *graph.value(heading[i]) = *graph.value(heading[i - 1]);
      std::copy_n(graph.value(position[i - 1]), 2, graph.value(position[i]));
    }
    window.AddBlock(position[i]);
    window.AddBlock(heading[i]);
    for (const int factor : arrivals[i]) window.AddFactor(factor);
    SolveGraph(window.part(), {}, &graph);
    if (i < kLength) continue;
    ASSERT_TRUE(window.Marginalize({position[i - kLength], heading[i - kLength]}));
    for (const int block : window.part().priors.back().blocks) {
      if (touched[static_cast<std::size_t>(block)]) continue;
      touched[static_cast<std::size_t>(block)] = true;
      const StateBlock& state = graph.block(block);
      first.segment(state.offset, state.size()) =
          graph.values().segment(state.offset, state.size());
    }
  }
  ASSERT_EQ(window.part().priors.size(), 1U);
  const LinearPrior& prior = window.part().priors.front();
  Eigen::MatrixXd moves = Eigen::MatrixXd::Zero(prior.jacobian.cols(), 3);
  Eigen::Index row = 0;
  const Eigen::Vector2d centre = first.segment<2>(graph.block(prior.blocks.front()).offset);
  for (const int block : prior.blocks) {
    const StateBlock& state = graph.block(block);
    if (state.id.kind == BlockKind::kPosition) {
      moves.block<2, 2>(row, 0).setIdentity();
      const Eigen::Vector2d arm = first.segment<2>(state.offset) - centre;
      moves.block<2, 1>(row, 2) = Eigen::Vector2d(-arm.y(), arm.x());
    } else {
      moves(row, 2) = 1;
    }
    row += state.size();
  }
  for (Eigen::Index c = 0; c < 3; ++c) moves.col(c).normalize();
  const Eigen::MatrixXd information = prior.jacobian.transpose() * prior.jacobian;
  EXPECT_GT(information.trace(), 1.0);
  EXPECT_LT((moves.transpose() * information * moves).trace(), 1e-9 * information.trace());
}

}  // namespace
}  // namespace walkgraph
