#ifndef WALKGRAPH_GRAPH_STATISTICS_H_
#define WALKGRAPH_GRAPH_STATISTICS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "graph/factor_graph.h"

namespace walkgraph {

// How well the measurements of one factor type fit.
struct ResidualStatistics {
  std::string type;
  std::int64_t count = 0;            // measurements
  int dimension = 0;                 // of each
  double mean_squared_whitened = 0;  // per dimension; about 1 where the noise model is right
  std::int64_t downweighted = 0;     // measurements whose robust weight fell under 1/2
};

// How well one factor fits: a scan's readings together, or a single measurement.
struct FactorFit {
  std::string type;
  TimeNs time_ns = 0;                // when its evidence arrived
  int count = 0;                     // measurements
  int dimension = 0;                 // of each
  double mean_squared_whitened = 0;  // per dimension
  int downweighted = 0;              // measurements whose robust weight fell under 1/2
};

// In the graph's order, at its values. Factors without whitened rows (hearing) are left out.
std::vector<FactorFit> ComputeFits(const FactorGraph& graph);

// By type, in alphabetical order.
std::vector<ResidualStatistics> PoolByType(const std::vector<FactorFit>& fits);

// Of ComputeFits.
std::vector<ResidualStatistics> ComputeStatistics(const FactorGraph& graph);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_STATISTICS_H_
