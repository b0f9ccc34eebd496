// A phone that the survey knows to hear louder than its fields is worth the same as one that hears
// as they do: adding to every reading what the model's walks had too much changes no estimate.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "solvers/baselines/mle.h"
#include "solvers/baselines/viterbi.h"
#include "solvers/batch_smoother.h"
#include "solvers/synthetic_site.h"
#include "solvers/window_smoother.h"

namespace walkgraph {
namespace {

using testing::SyntheticSite;

constexpr double kLouderDb = 4;  // a power of two: readings are floats

std::vector<std::unique_ptr<Estimator>> Methods(const FactorSettings& factors) {
  std::vector<std::unique_ptr<Estimator>> methods;
  methods.push_back(std::make_unique<MleEstimator>(MleSettings{}, WknnSettings{}, factors));
  methods.push_back(std::make_unique<Viterbi>(factors, DiscreteSettings{}));
  methods.push_back(std::make_unique<BatchSmoother>(factors, SolverSettings{}));
  methods.push_back(std::make_unique<WindowSmoother>(factors, SolverSettings{}, WindowSettings{}));
  return methods;
}

void ExpectSameWithTheLouderPhone(const FactorSettings& factors) {
  SyntheticSite synthetic(5);
  Evidence evidence = synthetic.Walk({{6, 6}, {40, 6}, {40, 28}}, 0.1, 3.0);
  evidence.device = "phone";
  Evidence louder = evidence;
  for (RadioReading& reading : louder.readings) reading.rssi_dbm += kLouderDb;
  Site plain = synthetic.site, known = synthetic.site;
  plain.loudness = {{"phone", Radio::kWifi, 0, 0.7}};
  known.loudness = {{"phone", Radio::kWifi, kLouderDb, 0.7}};
  for (const auto& method : Methods(factors)) {
    const Trajectory expected = method->Estimate(plain, evidence).trajectory;
    const Trajectory same = method->Estimate(known, louder).trajectory;
    const Trajectory moved = method->Estimate(plain, louder).trajectory;
    ASSERT_FALSE(expected.empty());
    ASSERT_EQ(same.poses.size(), expected.poses.size());
    double difference_m = 0, unknown_m = 0;
    for (std::size_t i = 0; i < expected.poses.size(); ++i) {
      const Eigen::Vector3d& at = expected.poses[i].position_m;
      difference_m = std::max(difference_m, (same.poses[i].position_m - at).norm());
      unknown_m = std::max(unknown_m, (moved.poses[i].position_m - at).norm());
    }
    EXPECT_LT(difference_m, 1e-3);
    EXPECT_GT(unknown_m, 0.1) << "what the test is about makes no difference";
  }
}

TEST(KnownPhone, IsWorthWhatOneIsThatHearsAsTheFieldsDo) { ExpectSameWithTheLouderPhone({}); }

TEST(KnownPhone, IsLevelledAlsoWhereTheOffsetIsHeld) {
  FactorSettings factors;
  factors.rssi_offset.mode = StateMode::kFixed;
  ExpectSameWithTheLouderPhone(factors);
}

}  // namespace
}  // namespace walkgraph
