#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_EXECUTOR_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_EXECUTOR_H_

#include <cstddef>
#include <functional>

namespace walkgraph {

// Runs job(i) for every i in [0, count), in any order and on any thread, and returns when all are
// done. Jobs write to slots of their own, so that no result hangs on how they were run. Threads are
// the caller's to start: training itself starts none.
using Executor =
    std::function<void(std::size_t count, const std::function<void(std::size_t)>& job)>;

inline void RunInOrder(std::size_t count, const std::function<void(std::size_t)>& job) {
  for (std::size_t i = 0; i < count; ++i) job(i);
}

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_EXECUTOR_H_
