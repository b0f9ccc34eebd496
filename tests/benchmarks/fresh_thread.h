#ifndef WALKGRAPH_TESTS_BENCHMARKS_FRESH_THREAD_H_
#define WALKGRAPH_TESTS_BENCHMARKS_FRESH_THREAD_H_

#include <thread>

namespace walkgraph {

// A thread remembers what the evidence of recent walks costs on a floor; here nothing is to be
// remembered from one iteration to the next.
template <typename Work>
void OnFreshThread(const Work& work) {
  std::thread(work).join();
}

}  // namespace walkgraph

#endif  // WALKGRAPH_TESTS_BENCHMARKS_FRESH_THREAD_H_
