#ifndef WALKGRAPH_EVAL_PARALLEL_H_
#define WALKGRAPH_EVAL_PARALLEL_H_

#include <cstddef>
#include <functional>
#include <vector>

#include "frontends/radio_map/executor.h"

namespace walkgraph {

// All threads of the project are started here; what runs on them is single-threaded. Jobs write to
// slots of their own, so that no result hangs on the number of workers.

// Runs job(i) for i in [0, count) on `workers` threads. Takes no new job once `stopped` says so.
// The first exception of a job stops the rest and is thrown again here.
void ParallelFor(int workers, std::size_t count, const std::function<bool()>& stopped,
                 const std::function<void(std::size_t)>& job);

// An executor of that many threads. It does not stop early: half of what it runs is of no use.
Executor ThreadedExecutor(int workers);

// What a cross-validation does with its folds and the walks that each holds out.
struct FoldJobs {
  std::function<void(std::size_t fold)> prepare;                // train; once per fold
  std::function<void(std::size_t fold, std::size_t walk)> run;  // after its fold is prepared
  std::function<void(std::size_t fold)> release;                // after its last walk
};

// Runs the folds, walks before further folds, so that few prepared folds are in memory at once.
// walks_of_fold[f] lists the walks that fold f holds out. Stops and throws like ParallelFor.
void RunFolds(int workers, const std::vector<std::vector<std::size_t>>& walks_of_fold,
              const FoldJobs& jobs, const std::function<bool()>& stopped);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_PARALLEL_H_
