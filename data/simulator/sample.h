#ifndef WALKGRAPH_DATA_SIMULATOR_SAMPLE_H_
#define WALKGRAPH_DATA_SIMULATOR_SAMPLE_H_

#include <cstdint>
#include <string>
#include <vector>

#include "data/building.h"
#include "data/simulator/simulated_walk.h"

namespace walkgraph {

struct Sample {
  Building building;
  std::vector<SimulatedWalk> walks;
};

// The sample that the demo runs on: one office floor, survey walks and test walks. The same seed
// gives the same sample.
Sample MakeSample(std::uint64_t seed);

// Writes building.json and the walks in walkgraph's CSV format below `out_dir`, which is made where
// it does not exist: `survey/walk_NN` and `test/walk_NN`. The same seed gives the same bytes.
// Throws InputError where a file cannot be written.
void SimulateSample(const std::string& out_dir, std::uint64_t seed);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_SAMPLE_H_
