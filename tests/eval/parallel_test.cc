#include "eval/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>

namespace walkgraph {
namespace {

bool Never() { return false; }

TEST(Parallel, RunsEveryJobOnce) {
  for (const int workers : {1, 2, 7}) {
    std::vector<std::atomic<int>> runs(100);
    ParallelFor(workers, runs.size(), Never, [&](std::size_t i) { ++runs[i]; });
    for (const auto& count : runs) EXPECT_EQ(count, 1);
  }
  ParallelFor(2, 0, Never, [](std::size_t) { FAIL(); });
}

TEST(Parallel, TakesNoJobAfterAStop) {
  std::atomic<int> done{0};
  ParallelFor(
      1, 100, [&] { return done >= 3; }, [&](std::size_t) { ++done; });
  EXPECT_EQ(done, 3);
}

TEST(Parallel, HandsOnTheExceptionOfAJob) {
  EXPECT_THROW(ParallelFor(3, 50, Never,
                           [](std::size_t i) {
                             if (i == 20) throw std::runtime_error("job");
                           }),
               std::runtime_error);
}

// Records what happened, and checks the order as it goes.
struct Recorder {
  std::mutex mutex;
  std::set<std::size_t> prepared, released, walks;

  FoldJobs Jobs() {
    return {.prepare =
                [this](std::size_t fold) {
                  const std::lock_guard<std::mutex> lock(mutex);
                  EXPECT_TRUE(prepared.insert(fold).second);
                },
            .run =
                [this](std::size_t fold, std::size_t walk) {
                  const std::lock_guard<std::mutex> lock(mutex);
                  EXPECT_TRUE(prepared.contains(fold));
                  EXPECT_FALSE(released.contains(fold));
                  EXPECT_TRUE(walks.insert(walk).second);
                },
            .release =
                [this](std::size_t fold) {
                  const std::lock_guard<std::mutex> lock(mutex);
                  EXPECT_TRUE(released.insert(fold).second);
                }};
  }
};

TEST(Parallel, FoldsArePreparedBeforeAndReleasedAfterTheirWalks) {
  for (const int workers : {1, 2, 5}) {
    Recorder recorder;
    RunFolds(workers, {{0, 3}, {}, {1, 2, 4}, {5}}, recorder.Jobs(), Never);
    EXPECT_EQ(recorder.walks.size(), 6u);
    EXPECT_EQ(recorder.prepared, (std::set<std::size_t>{0, 2, 3}));  // an empty fold costs nothing
    EXPECT_EQ(recorder.released, recorder.prepared);
  }
}

TEST(Parallel, AFailedPreparationEndsTheRun) {
  Recorder recorder;
  FoldJobs jobs = recorder.Jobs();
  jobs.prepare = [](std::size_t) { throw std::runtime_error("no memory"); };
  jobs.run = [](std::size_t, std::size_t) { FAIL(); };
  EXPECT_THROW(RunFolds(1, {{0}, {1}}, jobs, Never), std::runtime_error);
}

}  // namespace
}  // namespace walkgraph
