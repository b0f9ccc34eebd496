#include "solvers/window_smoother.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "solvers/batch_smoother.h"
#include "solvers/lagged_batch.h"
#include "solvers/synthetic_site.h"

namespace walkgraph {
namespace {

using testing::SyntheticSite;

const std::vector<Eigen::Vector2d> kLoop = {{6, 6}, {40, 6}, {40, 28}, {14, 28}};

double MeanError(const Trajectory& trajectory, const std::vector<Eigen::Vector2d>& truth) {
  double sum = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto pose = trajectory.At(SyntheticSite::At(static_cast<double>(i)));
    sum += (pose.position_m.head<2>() - truth[i]).norm();
  }
  return sum / static_cast<double>(truth.size());
}

TEST(WindowSmootherTest, TenSecondsCostLittleAgainstTheWholeWalk) {
  double batch_sum = 0, window_sum = 0, newest_sum = 0;
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    SyntheticSite synthetic(seed);
    std::vector<Eigen::Vector2d> truth;
    const Evidence evidence = synthetic.Walk(kLoop, 0.1, 3.0, &truth);
    batch_sum +=
        MeanError(BatchSmoother({}, {}).Estimate(synthetic.site, evidence).trajectory, truth);
    const EstimateResult window = WindowSmoother({}, {}, {}).Estimate(synthetic.site, evidence);
    window_sum += MeanError(window.trajectory, truth);
    WindowSettings newest;
    newest.report_newest = true;
    newest_sum += MeanError(
        WindowSmoother({}, {}, newest).Estimate(synthetic.site, evidence).trajectory, truth);
  }
  EXPECT_LT(window_sum, 1.3 * batch_sum);
  EXPECT_LT(window_sum, newest_sum);
}

// A lag longer than the walk has seen all of it; the shorter, the less it knows.
TEST(LaggedBatchTest, KnowsMoreTheLongerItWaits) {
  double batch_sum = 0, lagged_sum = 0, newest_sum = 0;
  for (std::uint32_t seed = 1; seed <= 2; ++seed) {
    SyntheticSite synthetic(seed);
    std::vector<Eigen::Vector2d> truth;
    const Evidence evidence = synthetic.Walk(kLoop, 0.1, 3.0, &truth);
    const Trajectory batch = BatchSmoother({}, {}).Estimate(synthetic.site, evidence).trajectory;
    const auto lagged = [&](double seconds) {
      WindowSettings window;
      window.seconds = seconds;
      return LaggedBatch({}, {}, window).Estimate(synthetic.site, evidence).trajectory;
    };
    const Trajectory all = lagged(1000);
    ASSERT_EQ(all.poses.size(), batch.poses.size());
    for (std::size_t i = 0; i < batch.poses.size(); ++i) {
      EXPECT_EQ(all.poses[i].position_m, batch.poses[i].position_m);
    }
    const Trajectory ten = lagged(10);
    ASSERT_EQ(ten.poses.size(), batch.poses.size());
    batch_sum += MeanError(batch, truth);
    lagged_sum += MeanError(ten, truth);
    newest_sum += MeanError(lagged(0), truth);
  }
  EXPECT_LT(batch_sum, lagged_sum);
  EXPECT_LT(lagged_sum, newest_sum);
}

// One access point alone, for 25 s, leaves the walk on a ring.
Evidence OnARingAtFirst(SyntheticSite& synthetic, std::vector<Eigen::Vector2d>* truth) {
  Evidence evidence = synthetic.Walk(kLoop, 0.1, 3.0, truth);
  const std::uint32_t only = evidence.readings.front().transmitter;
  std::erase_if(evidence.readings, [&](const RadioReading& reading) {
    return reading.heard_ns < SyntheticSite::At(25) && reading.transmitter != only;
  });
  return evidence;
}

// What left the window then would stay wrong.
TEST(WindowSmootherTest, KeepsItsNodesUntilTheWalkIsLocated) {
  double waiting_sum = 0, hasty_sum = 0, batch_sum = 0;
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    SyntheticSite synthetic(seed);
    std::vector<Eigen::Vector2d> truth;
    const Evidence evidence = OnARingAtFirst(synthetic, &truth);
    const auto error = [&](double located_sigma_m) {
      WindowSettings settings;
      settings.located_sigma_m = located_sigma_m;
      return MeanError(
          WindowSmoother({}, {}, settings).Estimate(synthetic.site, evidence).trajectory, truth);
    };
    waiting_sum += error(5);
    hasty_sum += error(1e6);
    batch_sum +=
        MeanError(BatchSmoother({}, {}).Estimate(synthetic.site, evidence).trajectory, truth);
  }
  EXPECT_LT(waiting_sum, 1.5 * batch_sum);
  // A hasty start may be lost and found again, but not without a price.
  EXPECT_LT(waiting_sum, hasty_sum);
}

// A window that lets nodes leave while the walk is anywhere on the ring loses the track, and takes
// it up again before the end.
TEST(WindowSmootherTest, FindsALostTrackAgain) {
  int found_again = 0;
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    SyntheticSite synthetic(seed);
    std::vector<Eigen::Vector2d> truth;
    const Evidence evidence = OnARingAtFirst(synthetic, &truth);
    WindowSettings hasty;
    hasty.located_sigma_m = 1e6;
    const EstimateResult window = WindowSmoother({}, {}, hasty).Estimate(synthetic.site, evidence);
    const Eigen::Vector2d end = window.trajectory.poses.back().position_m.head<2>();
    EXPECT_LT((end - truth.back()).norm(), 4.0) << "seed " << seed;
    for (const std::string& message : window.messages) {
      if (message.starts_with("lost the track")) ++found_again;
    }
  }
  EXPECT_GT(found_again, 0);
}

}  // namespace
}  // namespace walkgraph
