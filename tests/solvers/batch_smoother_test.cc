#include "solvers/batch_smoother.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "solvers/baselines/viterbi.h"
#include "solvers/synthetic_site.h"
#include "solvers/window_smoother.h"

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

TEST(BatchSmootherTest, BeatsTheDiscreteSmootherOnTheSameEvidence) {
  double batch_sum = 0, viterbi_sum = 0;
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    SyntheticSite synthetic(seed);
    std::vector<Eigen::Vector2d> truth;
    const Evidence evidence = synthetic.Walk(kLoop, 0.1, 3.0, &truth);
    const EstimateResult batch = BatchSmoother({}, {}).Estimate(synthetic.site, evidence);
    EXPECT_EQ(batch.status, EstimateStatus::kOk);
    batch_sum += MeanError(batch.trajectory, truth);
    viterbi_sum += MeanError(Viterbi({}, {}).Estimate(synthetic.site, evidence).trajectory, truth);
  }
  EXPECT_LT(batch_sum, 0.8 * viterbi_sum);
}

// Where the map extrapolates its error is larger: covariances say so, poses do not heed it.
// `least_ratio` bounds each pose's alone.
void ExpectWidensAwayFromTheSurvey(const Estimator& wide, const Estimator& narrow,
                                   double least_ratio) {
  SyntheticSite synthetic(1);
  const Evidence evidence = synthetic.Walk(kLoop, 0.1, 3.0);
  RadioMap& map = synthetic.site.maps.front();
  map.map_error_sigma_m = 1.0;
  map.map_error_growth = 0.5;
  const auto cells = static_cast<std::size_t>(map.grid.columns) * map.grid.rows;
  const auto spread = [](const PoseEstimate& pose) { return pose.covariance_xy_m2.trace(); };
  for (const double distance_m : {0.0, 6.0}) {
    map.survey_distance_m.assign(cells, static_cast<float>(distance_m));
    const Trajectory widened = wide.Estimate(synthetic.site, evidence).trajectory;
    const Trajectory model = narrow.Estimate(synthetic.site, evidence).trajectory;
    ASSERT_EQ(widened.poses.size(), model.poses.size());
    double widened_sum = 0, model_sum = 0;
    for (std::size_t i = 0; i < widened.poses.size(); ++i) {
      EXPECT_EQ(widened.poses[i].position_m, model.poses[i].position_m);
      if (distance_m == 0) {
        EXPECT_NEAR(spread(widened.poses[i]), spread(model.poses[i]), 1e-9);
      } else {
        EXPECT_GT(spread(widened.poses[i]), least_ratio * spread(model.poses[i]));
      }
      widened_sum += spread(widened.poses[i]);
      model_sum += spread(model.poses[i]);
    }
    // Three times the error, of which the walk's own averaging leaves a part.
    if (distance_m > 0) {
      EXPECT_GT(widened_sum, 2 * model_sum);
    }
  }
}

TEST(BatchSmootherTest, CovariancesWidenAwayFromTheSurveyAndPosesStay) {
  FactorSettings narrow;
  narrow.map_error.widens = false;
  ExpectWidensAwayFromTheSurvey(BatchSmoother({}, {}), BatchSmoother(narrow, {}), 2.0);
}

// What was marginalised holds the errors as the model has them: a pose may widen by less.
TEST(WindowSmootherTest, CovariancesWidenAwayFromTheSurveyAndPosesStay) {
  FactorSettings narrow;
  narrow.map_error.widens = false;
  ExpectWidensAwayFromTheSurvey(WindowSmoother({}, {}, {}), WindowSmoother(narrow, {}, {}), 1.0);
}

// Walls half a metre to either side of the loop.
Floor Hall(Floor floor) {
  floor.outline = {{{5.5, 5.5},
                    {40.5, 5.5},
                    {40.5, 28.5},
                    {13.5, 28.5},
                    {13.5, 27.5},
                    {39.5, 27.5},
                    {39.5, 6.5},
                    {5.5, 6.5}}};
  return floor;
}

TEST(BatchSmootherTest, WallsDrawTheWalkInAndClaimNoPrecision) {
  double free_sum = 0, walled_sum = 0, free_variance = 0, walled_variance = 0;
  FactorSettings open_factors;
  open_factors.area.kind = AreaKind::kNone;
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    SyntheticSite synthetic(seed);
    synthetic.site.building.floors = {Hall(synthetic.site.building.floors.front())};
    std::vector<Eigen::Vector2d> truth;
    const Evidence evidence = synthetic.Walk(kLoop, 0.1, 3.0, &truth);
    const Trajectory open =
        BatchSmoother(open_factors, {}).Estimate(synthetic.site, evidence).trajectory;
    const Trajectory walled = BatchSmoother({}, {}).Estimate(synthetic.site, evidence).trajectory;
    free_sum += MeanError(open, truth);
    walled_sum += MeanError(walled, truth);
    for (const PoseEstimate& pose : open.poses) free_variance += pose.covariance_xy_m2.trace();
    for (const PoseEstimate& pose : walled.poses) walled_variance += pose.covariance_xy_m2.trace();
  }
  EXPECT_LT(walled_sum, 0.95 * free_sum);
  EXPECT_NEAR(walled_variance / free_variance, 1, 0.1);
}

TEST(BatchSmootherTest, AnUnknownAreaChangesNothing) {
  SyntheticSite synthetic(3);
  const Evidence evidence = synthetic.Walk(kLoop, 0.1, 3.0);
  FactorSettings factors;
  factors.area.kind = AreaKind::kNone;
  // The default asks for the plan, of a building that has no outline.
  const Trajectory known = BatchSmoother({}, {}).Estimate(synthetic.site, evidence).trajectory;
  const Trajectory open = BatchSmoother(factors, {}).Estimate(synthetic.site, evidence).trajectory;
  ASSERT_EQ(known.poses.size(), open.poses.size());
  for (std::size_t i = 0; i < open.poses.size(); ++i) {
    EXPECT_EQ(known.poses[i].position_m, open.poses[i].position_m);
  }
}

}  // namespace
}  // namespace walkgraph
