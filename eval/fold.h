#ifndef WALKGRAPH_EVAL_FOLD_H_
#define WALKGRAPH_EVAL_FOLD_H_

#include <vector>

#include "eval/config.h"
#include "eval/cross_validation.h"
#include "eval/loaded_walk.h"
#include "eval/settings.h"
#include "frontends/radio_map/executor.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// The fold that holds each walk out (see GroupWalks and FoldOfGroup). Precondition: folds > 0.
std::vector<int> AssignFolds(const std::vector<const LoadedWalk*>& walks, SplitBy split, int folds);

// What is learnt from the training walks of one fold: none of it has seen a test walk.
struct Fold {
  Site site;
  Settings settings;  // calibrated on the training walks, then overridden by the user
};

// Trains and calibrates on `training`. Readings that also occur in a walk of `test` are removed
// first. Walks that could not be read or have no waypoints train nothing. A fold that is prepared
// alone may `run` its parts on threads.
Fold PrepareFold(const Building& building, const std::vector<const LoadedWalk*>& training,
                 const std::vector<const LoadedWalk*>& test,
                 const std::vector<ConfigOverride>& overrides, const Executor& run = RunInOrder);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_FOLD_H_
