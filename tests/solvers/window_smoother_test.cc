#include "solvers/window_smoother.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "solvers/batch_smoother.h"
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

}  // namespace
}  // namespace walkgraph
