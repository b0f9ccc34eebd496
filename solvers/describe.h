#ifndef WALKGRAPH_SOLVERS_DESCRIBE_H_
#define WALKGRAPH_SOLVERS_DESCRIBE_H_

#include <string>
#include <vector>

#include "graph/statistics.h"
#include "graph/walk_graph.h"
#include "solvers/estimator.h"
#include "solvers/modes.h"

namespace walkgraph {

// A solution as an estimator reports it: the mixture of the kept modes, the best one's slow states
// and statistics, and status and messages from what is observable. Leaves the walk at the best
// mode. Precondition: at least one mode.
EstimateResult Describe(WalkGraph& walk, const std::vector<Mode>& modes, double mode_limit_nats);

// What no evidence of the walk tells at the graph's values, one sentence per direction, with the
// factors that would tell it. Priors that only stand for ignorance do not count as evidence.
std::vector<std::string> DescribeUnobservable(const WalkGraph& walk);

// The graph's statistics as estimators report them.
std::vector<FactorStatistics> ToFactorStatistics(const std::vector<ResidualStatistics>& types);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_DESCRIBE_H_
