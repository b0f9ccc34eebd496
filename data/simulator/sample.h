#ifndef WALKGRAPH_DATA_SIMULATOR_SAMPLE_H_
#define WALKGRAPH_DATA_SIMULATOR_SAMPLE_H_

#include <cstdint>
#include <string>
#include <vector>

#include "data/building.h"
#include "data/recording.h"
#include "data/simulator/motion.h"
#include "data/truth.h"

namespace walkgraph {

// A simulated walk with everything that is true about it.
struct SimulatedWalk {
  std::string name;  // folder below the sample, "survey/walk_01"
  Recording recording;
  Truth truth;                  // at the start, the end, every turn and at least every 10 s
  std::vector<WalkState> path;  // where the person really was, at the rate of the IMU
};

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
