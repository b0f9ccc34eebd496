#include "solvers/baselines/mle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "solvers/synthetic_site.h"

namespace walkgraph {
namespace {

using testing::SyntheticSite;

const std::vector<Eigen::Vector2d> kRoute{{6, 6}, {42, 6}, {42, 30}, {6, 30}};

TEST(Mle, BeatsWknnWhereItsLikelihoodIsTrue) {
  SyntheticSite synthetic(21);
  double error[2] = {0, 0};
  for (int walk = 0; walk < 10; ++walk) {
    std::vector<Eigen::Vector2d> truth;
    const Evidence evidence = synthetic.Walk(kRoute, 0.1, 3, &truth);
    const auto mle = MleEstimator({}, {}, {}).Estimate(synthetic.site, evidence);
    const auto wknn = WknnEstimator::Wknn({}, {}).Estimate(synthetic.site, evidence);
    ASSERT_EQ(mle.status, EstimateStatus::kOk);
    for (std::size_t t = 0; t < truth.size(); ++t) {
      const TimeNs time = SyntheticSite::At(static_cast<double>(t));
      error[0] += (mle.trajectory.At(time).position_m.head<2>() - truth[t]).norm();
      error[1] += (wknn.trajectory.At(time).position_m.head<2>() - truth[t]).norm();
    }
  }
  EXPECT_LT(error[0], error[1]);
}

// At the scans themselves, readings independent as the simulation makes them (N_eff = N): the 95 %
// ellipse about the estimate holds the truth. It contains the estimate's own distance from the
// posterior's mean, so that it may be somewhat too wide but not too narrow.
TEST(Mle, CovarianceHoldsTheTruth) {
  SyntheticSite synthetic(22);
  FactorSettings factors;
  factors.fingerprint.n_eff = 100;
  double inside = 0, count = 0;
  for (int walk = 0; walk < 20; ++walk) {
    const Evidence evidence = synthetic.Walk({{6, 18}, {42, 18}}, 0.1, 3);
    const auto result = MleEstimator({}, {}, factors).Estimate(synthetic.site, evidence);
    for (double t = 1.5; t < 36; t += 3) {
      const PoseEstimate pose = result.trajectory.At(SyntheticSite::At(t));
      const Eigen::Vector2d d = pose.position_m.head<2>() - Eigen::Vector2d(6 + t, 18);
      inside += d.dot(pose.covariance_xy_m2.inverse() * d) < 5.991 ? 1 : 0;
      ++count;
    }
  }
  EXPECT_GT(inside / count, 0.92);
}

TEST(Mle, MapErrorWidensTheCovarianceByItsVariance) {
  SyntheticSite synthetic(23);
  const Evidence evidence = synthetic.Walk(kRoute, 0.1, 3);
  FactorSettings sharp, blurred;
  sharp.map_error.mode = StateMode::kAbsent;
  blurred.map_error.sigma_m = 2;
  const auto a = MleEstimator({}, {}, sharp).Estimate(synthetic.site, evidence).trajectory;
  const auto b = MleEstimator({}, {}, blurred).Estimate(synthetic.site, evidence).trajectory;
  const Eigen::Matrix2d added = b.poses[5].covariance_xy_m2 - a.poses[5].covariance_xy_m2;
  EXPECT_LT((added - 4 * Eigen::Matrix2d::Identity()).norm(), 1e-9);
}

TEST(Mle, NeedsARadioMapOfTheFloor) {
  SyntheticSite synthetic(24);
  const Evidence evidence = synthetic.Walk(kRoute, 0.1, 3);
  synthetic.site.maps.clear();
  const auto result = MleEstimator({}, {}, {}).Estimate(synthetic.site, evidence);
  EXPECT_EQ(result.status, EstimateStatus::kUnobservable);
  EXPECT_FALSE(result.trajectory.empty());
}

}  // namespace
}  // namespace walkgraph
