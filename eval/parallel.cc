#include "eval/parallel.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace walkgraph {
namespace {

// Runs `work` on this thread and workers - 1 others.
void OnThreads(int workers, const std::function<void()>& work) {
  std::vector<std::thread> threads;
  for (int i = 1; i < workers; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
}

// The queue of a cross-validation: walks that are ready, and folds not yet prepared.
class FoldQueue {
 public:
  FoldQueue(const std::vector<std::vector<std::size_t>>& walks_of_fold, const FoldJobs& jobs,
            const std::function<bool()>& stopped)
      : walks_of_fold_(walks_of_fold), jobs_(jobs), stopped_(stopped) {
    for (const auto& walks : walks_of_fold) remaining_.push_back(walks.size());
  }

  // What one thread does until nothing is left.
  void Work() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!error_ && !stopped_()) {
      if (!ready_.empty()) {
        RunWalk(&lock);
      } else if (next_fold_ < walks_of_fold_.size()) {
        PrepareFold(&lock);
      } else if (preparing_ > 0) {
        changed_.wait(lock);
      } else {
        return;
      }
    }
  }

  void RethrowError() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void RunWalk(std::unique_lock<std::mutex>* lock) {
    const auto [fold, walk] = ready_.front();
    ready_.pop_front();
    Unlocked(lock, [&, f = fold, w = walk] { jobs_.run(f, w); });
    if (--remaining_[fold] == 0) jobs_.release(fold);
  }

  void PrepareFold(std::unique_lock<std::mutex>* lock) {
    const std::size_t fold = next_fold_++;
    if (remaining_[fold] == 0) return;  // nothing to hold out
    ++preparing_;
    Unlocked(lock, [&] { jobs_.prepare(fold); });
    --preparing_;
    for (const std::size_t walk : walks_of_fold_[fold]) ready_.emplace_back(fold, walk);
    changed_.notify_all();
  }

  template <typename Job>
  void Unlocked(std::unique_lock<std::mutex>* lock, const Job& job) {
    lock->unlock();
    std::exception_ptr error;
    try {
      job();
    } catch (...) {
      error = std::current_exception();
    }
    lock->lock();
    if (error && !error_) error_ = error;
  }

  const std::vector<std::vector<std::size_t>>& walks_of_fold_;
  const FoldJobs& jobs_;
  const std::function<bool()>& stopped_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t next_fold_ = 0;
  int preparing_ = 0;
  std::deque<std::pair<std::size_t, std::size_t>> ready_;  // (fold, walk)
  std::vector<std::size_t> remaining_;                     // walks to go, by fold
  std::exception_ptr error_;
};

}  // namespace

void ParallelFor(int workers, std::size_t count, const std::function<bool()>& stopped,
                 const std::function<void(std::size_t)>& job) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr error;
  std::atomic<bool> failed{false};
  const int useful = static_cast<int>(std::min<std::size_t>(count, workers < 1 ? 1 : workers));
  OnThreads(useful, [&] {
    for (std::size_t i = next++; i < count && !failed && !stopped(); i = next++) {
      try {
        job(i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!error) error = std::current_exception();
        failed = true;
      }
    }
  });
  if (error) std::rethrow_exception(error);
}

Executor ThreadedExecutor(int workers) {
  return [workers](std::size_t count, const std::function<void(std::size_t)>& job) {
    ParallelFor(
        workers, count, [] { return false; }, job);
  };
}

void RunFolds(int workers, const std::vector<std::vector<std::size_t>>& walks_of_fold,
              const FoldJobs& jobs, const std::function<bool()>& stopped) {
  FoldQueue queue(walks_of_fold, jobs, stopped);
  OnThreads(workers, [&] { queue.Work(); });
  queue.RethrowError();
}

}  // namespace walkgraph
