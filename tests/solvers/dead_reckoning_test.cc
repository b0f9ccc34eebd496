#include "solvers/baselines/dead_reckoning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "solvers/synthetic_site.h"

namespace walkgraph {
namespace {

using testing::SyntheticSite;

EstimateResult DeadReckonWalk(const Site& site, const Evidence& evidence,
                              const FactorSettings& factors = {}) {
  return DeadReckoningEstimator({}, {}, factors).Estimate(site, evidence);
}

Eigen::Vector2d PositionAt(const EstimateResult& result, double seconds) {
  return result.trajectory.At(SyntheticSite::At(seconds)).position_m.head<2>();
}

TEST(DeadReckoning, FollowsTheWalkFromAnAnchorExactly) {
  SyntheticSite synthetic(1);
  Evidence evidence = synthetic.Walk({{5, 5}, {26, 5}, {26, 26}}, 0, 4);
  evidence.anchors.push_back({evidence.begin_ns, {5, 5}, 1, 0.1});
  const EstimateResult result = DeadReckonWalk(synthetic.site, evidence);
  EXPECT_EQ(result.status, EstimateStatus::kOk);
  EXPECT_LT((PositionAt(result, 10.3) - Eigen::Vector2d(15.3, 5)).norm(), 1e-6);
  EXPECT_LT((PositionAt(result, 35) - Eigen::Vector2d(26, 19)).norm(), 1e-6);
  EXPECT_NEAR(result.trajectory.poses.back().heading_rad, std::numbers::pi / 2, 1e-6);
}

TEST(DeadReckoning, TurnsWithTheBuildingAndTheCalibratedOffset) {
  SyntheticSite synthetic(1);
  Evidence evidence = synthetic.Walk({{5, 5}, {26, 5}}, 0, 4);
  evidence.anchors.push_back({evidence.begin_ns, {5, 5}, 1, 0.1});
  synthetic.site.building.origin = GeoReference{48, 11, 0.3};
  FactorSettings factors;
  factors.heading_offset.prior_mean_rad = 0.5;
  factors.step_scale.prior_mean = 1.1;
  const Eigen::Vector2d moved =
      PositionAt(DeadReckonWalk(synthetic.site, evidence, factors), 21) - Eigen::Vector2d(5, 5);
  EXPECT_NEAR(std::atan2(moved.y(), moved.x()), 0.2, 1e-9);
  EXPECT_NEAR(moved.norm(), 1.1 * 21, 1e-6);
}

TEST(DeadReckoning, BeginsAnewAtEachAnchor) {
  SyntheticSite synthetic(1);
  Evidence evidence = synthetic.Walk({{5, 5}, {26, 5}}, 0, 4);
  evidence.anchors.push_back({SyntheticSite::At(14), {100, 7}, 1, 0.1});
  evidence.anchors.push_back({SyntheticSite::At(7), {12, 5}, 1, 0.1});
  const EstimateResult result = DeadReckonWalk(synthetic.site, evidence);
  EXPECT_NEAR(PositionAt(result, 0).x(), 5, 1e-6);
  EXPECT_NEAR(PositionAt(result, 13).x(), 18, 1e-6);
  EXPECT_NEAR(PositionAt(result, 14).x(), 100, 1e-6);
  EXPECT_NEAR(PositionAt(result, 15).x(), 101, 1e-6);
}

TEST(DeadReckoning, StartsWhereTheFirstScansAgree) {
  SyntheticSite synthetic(2);
  double error = 0;
  for (int walk = 0; walk < 20; ++walk) {
    const Evidence evidence = synthetic.Walk({{10, 12}, {31, 12}, {31, 26}}, 0, 3);
    error +=
        (PositionAt(DeadReckonWalk(synthetic.site, evidence), 0) - Eigen::Vector2d(10, 12)).norm() /
        20;
  }
  EXPECT_LT(error, 4.0);
}

TEST(DeadReckoning, SaysWhatItCannotKnow) {
  SyntheticSite synthetic(3);
  Evidence evidence = synthetic.Walk({{5, 5}, {26, 5}}, 0, 4);
  Evidence deaf = evidence;
  deaf.readings.clear();
  const EstimateResult from_centroid = DeadReckonWalk(synthetic.site, deaf);
  EXPECT_EQ(from_centroid.status, EstimateStatus::kUnobservable);
  EXPECT_NEAR(PositionAt(from_centroid, 0).x(), 24.5, 1e-9);
  EXPECT_NEAR(PositionAt(from_centroid, 21).x(), 45.5, 1e-6);

  Evidence lost = evidence;
  lost.absolute_heading_rad = {};
  lost.absolute_heading_sigma_rad.clear();
  EXPECT_EQ(DeadReckonWalk(synthetic.site, lost).status, EstimateStatus::kUnobservable);
}

TEST(DeadReckoning, StandsStillWithoutSteps) {
  SyntheticSite synthetic(4);
  Evidence evidence = synthetic.Walk({{5, 5}, {26, 5}}, 0, 4);
  evidence.steps.clear();
  const EstimateResult result = DeadReckonWalk(synthetic.site, evidence);
  EXPECT_TRUE(PositionAt(result, 0).isApprox(PositionAt(result, 20)));
}

}  // namespace
}  // namespace walkgraph
