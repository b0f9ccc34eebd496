#ifndef WALKGRAPH_TESTS_REAL_RECORDED_WALKS_H_
#define WALKGRAPH_TESTS_REAL_RECORDED_WALKS_H_

#include <vector>

#include "data/dataset.h"
#include "eval/loaded_walk.h"

namespace walkgraph {

// All walks of a data set with default settings, their floors told.
inline std::vector<LoadedWalk> LoadRecordedWalks(const Dataset& dataset) {
  std::vector<LoadedWalk> walks;
  for (const WalkFile& file : dataset.walks) {
    walks.push_back(LoadWalk(file, dataset.building, {}, true));
  }
  return walks;
}

}  // namespace walkgraph

#endif  // WALKGRAPH_TESTS_REAL_RECORDED_WALKS_H_
