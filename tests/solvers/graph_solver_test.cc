#include "solvers/graph_solver.h"

#include <gtest/gtest.h>

#include "factors/loss.h"
#include "factors/prior.h"
#include "graph/graph_part.h"

namespace walkgraph {
namespace {

constexpr LossSettings kCauchy{LossKind::kCauchy, 1.0};

// Measurements under a loss that makes every step but a part of the way.
void AddMeasurements(FactorGraph* graph) {
  const int block = graph->AddBlock({BlockKind::kStepScale, 0}, 0, Eigen::VectorXd::Constant(1, 4));
  for (const double value : {1.0, 1.3, 1.9, 6.0}) {
    GraphFactor factor = MakeGraphFactor(StatePriorFactor{value, 0.3}, {block});
    factor.loss = MakeLoss(kCauchy, 1);
    graph->AddFactor(std::move(factor));
  }
}

// Two measurements of another unknown that contradict each other, at their mean already.
void AddContradiction(double apart, FactorGraph* graph) {
  const int block =
      graph->AddBlock({BlockKind::kGyroBias, 0}, 0, Eigen::VectorXd::Constant(1, apart / 2));
  graph->AddFactor(MakeGraphFactor(StatePriorFactor{0.0, 1e-3}, {block}));
  graph->AddFactor(MakeGraphFactor(StatePriorFactor{apart, 1e-3}, {block}));
}

TEST(SolveGraph, WhatACostHoldsBesidesDoesNotEndTheSearch) {
  FactorGraph alone;
  AddMeasurements(&alone);
  ASSERT_TRUE(SolveGraph(WholeGraph(alone), {}, &alone).ok);
  for (const double apart : {0.1, 10.0}) {  // 5,000 and 5e7 nats that no step takes off
    FactorGraph graph;
    AddMeasurements(&graph);
    AddContradiction(apart, &graph);
    ASSERT_TRUE(SolveGraph(WholeGraph(graph), {}, &graph).ok);
    EXPECT_NEAR(*graph.value(0), *alone.value(0), 1e-6) << apart;
  }
}

TEST(SolveGraph, EndsWithTheStepThatGainsLessThanAsked) {
  FactorGraph exact;
  AddMeasurements(&exact);
  const SolveResult all = SolveGraph(WholeGraph(exact), {.tolerance_nats = 1e-12}, &exact);
  int before = all.iterations;
  for (const double tolerance : {1e-6, 1e-2, 1e2}) {
    FactorGraph graph;
    AddMeasurements(&graph);
    const SolveResult result = SolveGraph(WholeGraph(graph), {.tolerance_nats = tolerance}, &graph);
    EXPECT_LE(result.iterations, before) << tolerance;
    before = result.iterations;
  }
  EXPECT_EQ(before, 2);  // the start, and one step
  EXPECT_GT(all.iterations, 4);
}

}  // namespace
}  // namespace walkgraph
