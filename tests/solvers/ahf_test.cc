#include "solvers/baselines/ahf/ahf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "solvers/baselines/ahf/dynamic_weights.h"
#include "solvers/synthetic_site.h"

namespace walkgraph {
namespace {

using Eigen::Vector2d;
using testing::SyntheticSite;

constexpr double kDt = 2;

RatedFix Fix(double x, double y, double error_m = 4) {
  RatedFix rated;
  rated.fix.position_m = {x, y};
  rated.error_m = error_m;
  return rated;
}

const AhfMethod& MethodNamed(std::string_view name) {
  return *std::find_if(std::begin(kAhfMethods), std::end(kAhfMethods),
                       [&](const AhfMethod& m) { return m.description.name == name; });
}

EstimateResult RunMethod(std::string_view name, const Site& site, const Evidence& evidence) {
  return AhfEstimator(MethodNamed(name), {}, {}, {}).Estimate(site, evidence);
}

TEST(Ahf, BestCandidateSetIsTheMeanDistanceFromTheBest) {
  const std::vector<Vector2d> candidates{{0, 0}, {3, 4}, {0, 2}};
  EXPECT_DOUBLE_EQ(BestCandidateSetError(candidates, 2), 3.5);
  EXPECT_DOUBLE_EQ(BestCandidateSetError(candidates, 9), 4.5);  // half the spacing at least
  EXPECT_DOUBLE_EQ(BestCandidateSetError(std::vector<Vector2d>{{1, 1}}, 2), 1);
}

TEST(Ahf, WeighsByTheErrorsSoFar) {
  DynamicWeights weights;
  EXPECT_DOUBLE_EQ(weights.NextMeasurementWeight(2), 1);
  EXPECT_DOUBLE_EQ(weights.NextMeasurementWeight(4), 2.0 / 6);  // 2 before, 4 now
  EXPECT_DOUBLE_EQ(weights.NextMeasurementWeight(6), 1.0 / 3);  // errors 2, 4 then 6
}

TEST(Ahf, MovesAlongTheWayThatIsNearestToTheFix) {
  const WayGraph ways({{{0, 0}, {10, 0}, {30, 0}, {10, 20}}, {{0, 1}, {1, 2}, {1, 3}}});
  AhfSettings settings;
  settings.start_speed_mps = 1;
  const auto filter = MakeAhfFilter(AhfPrediction::kWays, AhfWeights::kDynamic, &ways, settings);
  EXPECT_EQ(filter->Advance(Fix(9, 0), 0).position_m, Vector2d(9, 0));
  // 2 m from (9, 0): (7, 0), (11, 0) or (10, 1); the last is nearest, both weigh the same.
  const Vector2d second = filter->Advance(Fix(10, 5), kDt).position_m;
  EXPECT_NEAR((second - Vector2d(10, 3)).norm(), 0, 1e-12);
  // Speed sqrt(1 + 9) / 2 m/s; (10, 3) is on a way: 3.162 m north.
  const Vector2d third = filter->Advance(Fix(14, 8), kDt).position_m;
  EXPECT_NEAR((third - Vector2d(12, (3 + std::sqrt(10) + 8) / 2)).norm(), 0, 1e-12);
}

TEST(Ahf, KalmanOnAStraightWayAgreesWithTheOneWithoutWays) {
  const WayGraph ways({{{-1000, 0}, {1000, 0}}, {{0, 1}}});
  AhfSettings settings;
  settings.acceleration_sigma_mps2 = 0.01;
  const auto on_ways = MakeAhfFilter(AhfPrediction::kWays, AhfWeights::kKalman, &ways, settings);
  const auto straight =
      MakeAhfFilter(AhfPrediction::kStraight, AhfWeights::kKalman, nullptr, settings);
  PositionFix a, b;
  for (int k = 0; k < 60; ++k) {
    a = on_ways->Advance(Fix(1.2 * kDt * k, 0), kDt);
    b = straight->Advance(Fix(1.2 * kDt * k, 0), kDt);
  }
  EXPECT_NEAR(a.position_m.x(), 1.2 * kDt * 59, 0.1);
  EXPECT_NEAR(b.position_m.x(), 1.2 * kDt * 59, 0.1);
  EXPECT_NEAR(a.covariance_m2(0, 0) / b.covariance_m2(0, 0), 1, 0.2);
}

// With no limit on speed the particles sample the Kalman filter's very model.
TEST(Ahf, ManyParticlesAreTheKalmanFilter) {
  AhfSettings settings;
  settings.max_speed_mps = 1e6;
  const auto kalman =
      MakeAhfFilter(AhfPrediction::kStraight, AhfWeights::kKalman, nullptr, settings);
  const auto particles = MakeParticleFilter(100'000, AhfWeights::kKalman, settings);
  for (int k = 0; k < 12; ++k) {
    const RatedFix fix = Fix(2.0 * k + 3 * std::sin(5.0 * k), k - 4 * std::cos(3.0 * k));
    const PositionFix expected = kalman->Advance(fix, kDt);
    const PositionFix found = particles->Advance(fix, kDt);
    if (k == 0) continue;  // the first fix is all that the Kalman filter knows
    EXPECT_NEAR((found.position_m - expected.position_m).norm(), 0, 0.1) << k;
    EXPECT_NEAR(found.covariance_m2.trace() / expected.covariance_m2.trace(), 1, 0.5) << k;
  }
}

TEST(Ahf, ParticlesNeverRunFasterThanPeople) {
  const FreeMotion motion{5, 5, 2};
  ParticleFilter filter(2'000, motion, 1, {0, 0}, 0.01);
  filter.Predict(1);
  filter.Predict(0);
  const double spread_before = std::sqrt(filter.Estimate().covariance_m2.trace());
  ParticleFilter slow(2'000, {0, 5, 2}, 1, {0, 0}, 0.01);
  slow.Predict(0);   // limits the speeds
  slow.Predict(10);  // 20 m at most
  EXPECT_LT(std::sqrt(slow.Estimate().covariance_m2.trace()), 20);
  EXPECT_GT(spread_before, 1);
}

TEST(Ahf, AFixFarFromAllParticlesLeavesThemFinite) {
  ParticleFilter filter(100, {0.5, 1, 2}, 1, {0, 0}, 1);
  filter.Update({1e6, 0}, 1);
  EXPECT_TRUE(filter.Estimate().mean_m.allFinite());
}

TEST(Ahf, RunsTwiceToTheSameBytes) {
  SyntheticSite world(3);
  const Evidence evidence = world.Walk({{4, 4}, {40, 4}, {40, 30}}, 0.1, 2.0);
  for (const AhfMethod& method : kAhfMethods) {
    const EstimateResult a = RunMethod(method.description.name, world.site, evidence);
    const EstimateResult b = RunMethod(method.description.name, world.site, evidence);
    EXPECT_EQ(a.status, EstimateStatus::kOk);
    ASSERT_EQ(a.trajectory.poses.size(), b.trajectory.poses.size());
    for (std::size_t i = 0; i < a.trajectory.poses.size(); ++i) {
      EXPECT_EQ(a.trajectory.poses[i].position_m, b.trajectory.poses[i].position_m);
      EXPECT_TRUE(a.trajectory.poses[i].position_m.allFinite());
    }
  }
}

double MeanError(const EstimateResult& result, const std::vector<Vector2d>& truth) {
  double sum = 0;
  for (std::size_t s = 0; s < truth.size(); ++s) {
    const PoseEstimate pose = result.trajectory.At(SyntheticSite::At(static_cast<double>(s)));
    sum += (pose.position_m.head<2>() - truth[s]).norm() / static_cast<double>(truth.size());
  }
  return sum;
}

// Walks along the survey's lines: what the paper calls hallways.
TEST(Ahf, WaysHelpWhereTheyAreRight) {
  double wknn = 0, ahf = 0;
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    SyntheticSite world(seed);
    world.site.building.floors[0].ways = {{{1.5, 7.5}, {46.5, 7.5}}, {{0, 1}}};
    std::vector<Vector2d> truth;
    const Evidence evidence = world.Walk({{2, 7.5}, {46, 7.5}}, 0.1, 2.0, &truth);
    wknn += MeanError(WknnEstimator::Wknn({}, {}).Estimate(world.site, evidence), truth);
    ahf += MeanError(RunMethod("ahf", world.site, evidence), truth);
  }
  EXPECT_LT(ahf, 0.9 * wknn);
}

TEST(Ahf, ReportsTheEstimatedErrorOfEveryFix) {
  SyntheticSite world(3);
  const Evidence evidence = world.Walk({{4, 4}, {40, 4}}, 0.1, 2.0);
  const EstimateResult result = RunMethod("ahf", world.site, evidence);
  EXPECT_EQ(result.slow_states.size(), 18U);
  for (const SlowStateEstimate& state : result.slow_states) {
    EXPECT_EQ(state.name, "bcs_error_m");
    EXPECT_GE(state.value, 1);
  }
}

TEST(Ahf, WithoutAnyWayItIsUnsupportedAndSaysSo) {
  SyntheticSite world(3);
  const Evidence evidence = world.Walk({{4, 4}, {40, 4}}, 0.1, 2.0);
  world.site.path.clear();
  for (const std::string_view name : {"ahf", "ahf_ways_kalman"}) {
    const EstimateResult result = RunMethod(name, world.site, evidence);
    EXPECT_EQ(result.status, EstimateStatus::kUnsupported);
    ASSERT_EQ(result.messages.size(), 1U);
    EXPECT_NE(result.messages[0].find("way network"), std::string::npos);
  }
  EXPECT_EQ(RunMethod("ahf_kalman", world.site, evidence).status, EstimateStatus::kOk);
}

}  // namespace
}  // namespace walkgraph
