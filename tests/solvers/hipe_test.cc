#include "solvers/baselines/hipe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "data/angle.h"
#include "solvers/synthetic_site.h"

namespace walkgraph {
namespace {

using testing::SyntheticSite;

// Three reference points at 0, 3 and 6 m on a line.
ReferencePoints Line() { return ReferencePoints({{0, 0}, {1, 0}, {2, 0}}, {0, 0}, 3); }

MotionInformation Ring(double distance_m) {
  MotionInformation motion;
  motion.distance_m = distance_m;
  motion.distance_tolerance_m = 1.5;
  return motion;
}

std::vector<double> Log(std::vector<double> values) {
  for (double& value : values) value = std::log(value);
  return values;
}

TEST(HipeTransition, GivesConsistentPairsKTimesTheOthers) {
  ConsistentPairs pairs;
  for (int i = 0; i < 100; ++i) {
    if (i != 7) pairs.to.insert(pairs.to.end(), {1, 2, 3, 5, 8});
    pairs.begin.push_back(pairs.to.size());
  }
  const TransitionRows rows = HipeTransition(pairs, 200);
  EXPECT_NEAR(rows.elsewhere[0], 1.0 / 1095, 1e-15);
  EXPECT_NEAR(rows.Row(0)[0].probability, 0.182648, 5e-7);
  EXPECT_DOUBLE_EQ(rows.elsewhere[7], 0.01);  // none is consistent
  for (std::size_t i = 0; i < rows.size(); ++i) {
    double sum = rows.elsewhere[i] * static_cast<double>(100 - rows.Row(i).size());
    for (const auto& entry : rows.Row(i)) sum += entry.probability;
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_GT(rows.elsewhere[i], 0);
  }
}

TEST(Hipe, FilterViterbiAndMleDifferAsOnPaper) {
  const ReferencePoints points = Line();
  const ReferencePairs pairs(points, {}, HipeDistance::kEuclidean, 40);
  const TransitionRows rows = HipeTransition(pairs.Find(Ring(3)), 200);
  const std::vector<double> first{.6, .3, .1}, second{.4, .3, .3};
  const std::vector<double> start(3, 1.0 / 3);
  const std::vector<double> posterior = UpdateDistribution(
      PredictDistribution(rows, UpdateDistribution(start, Log(first))), Log(second));
  EXPECT_NEAR(posterior[0], 0.19421, 5e-6);
  EXPECT_NEAR(posterior[1], 0.66013, 5e-6);
  EXPECT_NEAR(posterior[2], 0.14566, 5e-6);
  EXPECT_EQ(ArgMax(second), 0);
  ViterbiStep step = AdvanceViterbi(rows, Log(first));
  for (std::size_t i = 0; i < 3; ++i) step.log_score[i] += std::log(second[i]);
  EXPECT_EQ(TraceViterbi({step.from}, step.log_score), (std::vector{0, 1}));
}

TEST(Weibull, HasTheMomentsItWasMadeOf) {
  const Weibull weibull = WeibullFromMoments(2, -70, 4);
  EXPECT_NEAR(weibull.scale_db, 8.63462, 5e-6);
  EXPECT_NEAR(weibull.shift_dbm, -77.65223, 5e-6);
  double mass = 0, mean = 0, square = 0;
  for (int rssi = -100; rssi <= -30; ++rssi) {
    const double p = BinProbability(weibull, rssi);
    mass += p;
    mean += p * rssi;
    square += p * (rssi + 70) * (rssi + 70);
  }
  EXPECT_NEAR(mass, 1, 1e-6);
  EXPECT_NEAR(mean, -70, 0.01);
  EXPECT_NEAR(square, 16 + 1.0 / 12, 0.05);  // the bins add a twelfth
}

TEST(Weibull, ShapeFollowsFromSkewness) {
  EXPECT_NEAR(WeibullSkewness(1), 2, 1e-9);  // exponential
  EXPECT_NEAR(WeibullSkewness(2),
              2 * std::sqrt(std::numbers::pi) * (std::numbers::pi - 3) /
                  std::pow(4 - std::numbers::pi, 1.5),
              1e-9);  // Rayleigh
  EXPECT_NEAR(WeibullShape(WeibullSkewness(4.2)), 4.2, 1e-9);
  EXPECT_NEAR(WeibullShape(50), 1, 1e-9);
}

TEST(HipeMotion, DistancesOfThePaperAreTwoPercentLong) {
  // Steps counted on the eight legs of 39 m: table 3 of the paper.
  double rate = 0;
  for (const int steps : {60, 59, 60, 58, 54, 55, 53, 55}) {
    Evidence evidence;
    for (int i = 0; i < steps; ++i) {
      evidence.steps.push_back({i * kNsPerSecond / 2, (i + 1) * kNsPerSecond / 2, 0.9});
    }
    const MotionInformation motion = MeasureMotion(evidence, {}, 1, 0, steps * kNsPerSecond, 3, {});
    rate += (*motion.distance_m - 39) / 39 / 8;
  }
  EXPECT_NEAR(rate, 0.01859, 5e-6);
}

TEST(HipeMotion, MeasuresWhatTheCaseNamesAndToleratesWhatThePaperSays) {
  SyntheticSite synthetic(1);
  const Evidence evidence = synthetic.Walk({{2, 2}, {44, 2}}, 0, 4);
  const DeadReckonedPath path = DeadReckon(synthetic.site, evidence, {});
  const TimeNs begin = SyntheticSite::At(1.05), end = SyntheticSite::At(36.05);
  HipeMotionSettings settings;
  const auto measure = [&](HipeCase motion_case) {
    settings.motion_case = motion_case;
    return MeasureMotion(evidence, path, 1, begin, end, 3, settings);
  };
  const MotionInformation both = measure(HipeCase::kDistanceHeading);
  EXPECT_NEAR(*both.distance_m, 35, 1e-6);
  EXPECT_NEAR(both.distance_tolerance_m, 3.5, 1e-6);
  EXPECT_NEAR(*both.heading_rad, 0, 1e-9);
  EXPECT_NEAR(RadiansToDegrees(both.heading_tolerance_rad), 55, 1e-9);
  EXPECT_FALSE(measure(HipeCase::kDistance).heading_rad);
  EXPECT_FALSE(measure(HipeCase::kHeadingSpeed).distance_m);
  EXPECT_NEAR(measure(HipeCase::kSpeed).range_m, 35, 1e-9);
  // Short ways keep half the spacing.
  EXPECT_NEAR(MeasureMotion(evidence, path, 1, begin, SyntheticSite::At(3.15), 3, settings)
                  .distance_tolerance_m,
              0, 1e-12);
  settings.motion_case = HipeCase::kDistance;
  EXPECT_NEAR(MeasureMotion(evidence, path, 1, begin, SyntheticSite::At(3.15), 3, settings)
                  .distance_tolerance_m,
              1.5, 1e-12);
}

TEST(HipeMotion, StandingAllowsOnlyStaying) {
  const ReferencePoints points = Line();
  const ReferencePairs pairs(points, {}, HipeDistance::kEuclidean, 40);
  MotionInformation standing = Ring(0);
  standing.heading_rad = 1.0;
  standing.heading_tolerance_rad = DegreesToRadians(55);
  const ConsistentPairs stay = pairs.Find(standing);
  EXPECT_EQ(stay.to, (std::vector{0, 1, 2}));
  EXPECT_EQ(stay.begin, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(HipeMotion, RingAndSectorMeetOnALattice) {
  std::vector<ReferencePoints::Cell> cells;
  for (int r = 0; r < 11; ++r) {
    for (int c = 0; c < 11; ++c) cells.push_back({c, r});
  }
  const ReferencePoints points(cells, {0, 0}, 3);
  MotionInformation motion = Ring(9);
  motion.heading_rad = std::numbers::pi - 0.01;  // west, across the wrap
  motion.heading_tolerance_rad = DegreesToRadians(55);
  for (const HipeDistance distance : {HipeDistance::kEuclidean, HipeDistance::kWalkable}) {
    const ReferencePairs pairs(points, {}, distance, 40);
    const ConsistentPairs found = pairs.Find(motion);
    const std::size_t middle = 5 * 11 + 5;
    int count = 0;
    for (std::size_t e = found.begin[middle]; e < found.begin[middle + 1]; ++e) {
      const Eigen::Vector2d d = points.positions_m()[static_cast<std::size_t>(found.to[e])] -
                                points.positions_m()[middle];
      EXPECT_LT(std::abs(d.norm() - 9), 1.5);
      EXPECT_GT(-d.x() / d.norm(), std::cos(DegreesToRadians(56)));
      ++count;
    }
    // 3 columns left: rows -1..1; 2 columns: rows +-2; and the mirror images on the ring's rim.
    EXPECT_GE(count, 5);
    EXPECT_LE(count, 9);
  }
}

TEST(HipeMotion, WalkableDistanceGoesAroundAWall) {
  std::vector<ReferencePoints::Cell> cells;
  for (int r = 0; r < 7; ++r) {
    for (int c = 0; c < 2; ++c) cells.push_back({c, r});
  }
  const ReferencePoints points(cells, {0, 0}, 3);
  // A wall between the columns that leaves a gap at the top.
  const std::vector<Polygon> wall{{{1.4, -5}, {1.6, -5}, {1.6, 16.6}, {1.4, 16.6}}};
  const auto ways = FindWalkableWays(points, wall, 60);
  const auto free_ways = FindWalkableWays(points, {}, 60);
  ASSERT_EQ(ways[0].size(), points.size());
  EXPECT_NEAR(ways[0][0].distance_m, 0, 0);
  EXPECT_NEAR(free_ways[0][1].distance_m, 3, 1e-12);
  EXPECT_GT(ways[0][1].distance_m, 2 * 16);
  EXPECT_LT(ways[0][1].distance_m, 2 * 18 + 3 + 1e-9);
}

TEST(HipeMotion, KGrowsWithConfidenceBetweenItsLimits) {
  const HipeSettings settings;
  EXPECT_DOUBLE_EQ(AdaptiveK(0, 1, settings), 200);
  EXPECT_DOUBLE_EQ(AdaptiveK(1, 1, settings), 200'000);
  EXPECT_LT(AdaptiveK(0.5, 0.5, settings), AdaptiveK(0.5, 0.9, settings));
}

TEST(HipeEmission, PrefersThePointWhereTheReadingsWereTaken) {
  SyntheticSite synthetic(4, 16);
  const ReferencePoints points(synthetic.site, 1, {});
  const std::vector<Eigen::Vector2d> path{{8, 8}, {40, 8}, {40, 28}};
  const Evidence evidence = synthetic.Walk(path, 0.1, 3);
  const auto scans = CollectQueryScans(synthetic.site, evidence, 3);
  std::vector<std::uint32_t> all(16);
  std::iota(all.begin(), all.end(), 0U);
  const HipeEmission emission(synthetic.site, 1, points, all, 3, {});
  EXPECT_NEAR(emission.pooled_sd_db(), SyntheticSite::kNoiseDb, 1.5);
  EXPECT_NEAR(WeibullSkewness(emission.shape()), 0, 0.5);  // the noise is symmetric
  double error = 0;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const auto best = static_cast<std::size_t>(ArgMax(emission.LogLikelihood(scans[k].signal)));
    const double walked = SecondsBetween(evidence.begin_ns, scans[k].time_ns);
    const Eigen::Vector2d truth =
        walked < 32 ? Eigen::Vector2d(8 + walked, 8) : Eigen::Vector2d(40, 8 + walked - 32);
    error += (points.positions_m()[best] - truth).norm() / static_cast<double>(scans.size());
  }
  EXPECT_LT(error, 5);
}

// Mean error over walks of one solver and case.
double MeanError(SyntheticSite synthetic, HipeSolver solver, HipeCase motion_case) {
  HipeSettings settings;
  settings.motion.motion_case = motion_case;
  FactorSettings factors;
  const HipeEstimator hipe(solver, settings, {}, factors);
  const std::vector<std::vector<Eigen::Vector2d>> routes{
      {{6, 6}, {42, 6}, {42, 30}, {6, 30}, {6, 10}},
      {{40, 30}, {10, 30}, {10, 6}, {36, 6}},
      {{24, 4}, {24, 32}, {44, 32}, {44, 8}},
      {{5, 20}, {43, 20}, {20, 20}, {20, 5}}};
  double sum = 0, count = 0;
  for (int repeat = 0; repeat < 5; ++repeat) {
    for (const auto& route : routes) {
      std::vector<Eigen::Vector2d> truth;
      const Evidence evidence = synthetic.Walk(route, 0.2, 6, &truth);
      const EstimateResult result = hipe.Estimate(synthetic.site, evidence);
      EXPECT_EQ(result.status, EstimateStatus::kOk);
      for (std::size_t t = 0; t < truth.size(); ++t) {
        const PoseEstimate pose = result.trajectory.At(SyntheticSite::At(static_cast<double>(t)));
        sum += (pose.position_m.head<2>() - truth[t]).norm();
        ++count;
      }
    }
  }
  return sum / count;
}

// The paper's table 5: the filter with distance and heading, distance, heading and speed, speed;
// and no motion at all last. Few access points, so that motion has something to add.
TEST(Hipe, MoreMotionInformationIsNotWorse) {
  const SyntheticSite synthetic(11, 5);
  const auto filter = [&](HipeCase c) { return MeanError(synthetic, HipeSolver::kFilter, c); };
  const double both = filter(HipeCase::kDistanceHeading), distance = filter(HipeCase::kDistance);
  const double heading = filter(HipeCase::kHeadingSpeed), speed = filter(HipeCase::kSpeed);
  EXPECT_LE(both, distance);
  EXPECT_LE(both, heading);
  EXPECT_LE(distance, speed);
  EXPECT_LE(heading, speed);
  // "Viterbi about equal" (figure 12).
  const double viterbi = MeanError(synthetic, HipeSolver::kViterbi, HipeCase::kDistanceHeading);
  EXPECT_NEAR(viterbi, both, 0.25 * both);
}

TEST(Hipe, SaysWhenItCannotSee) {
  SyntheticSite synthetic(12);
  Evidence evidence = synthetic.Walk({{6, 6}, {42, 6}}, 0.2, 4);
  const HipeEstimator hipe(HipeSolver::kFilter, {}, {}, {});
  Evidence elsewhere = evidence;
  elsewhere.floor = 9;
  EXPECT_EQ(hipe.Estimate(synthetic.site, elsewhere).status, EstimateStatus::kUnobservable);
  Evidence deaf = evidence;
  deaf.readings.clear();
  EXPECT_EQ(hipe.Estimate(synthetic.site, deaf).status, EstimateStatus::kUnobservable);
  Evidence no_compass = evidence;
  no_compass.absolute_heading_rad = {};
  no_compass.absolute_heading_sigma_rad.clear();
  const EstimateResult result = hipe.Estimate(synthetic.site, no_compass);
  EXPECT_EQ(result.status, EstimateStatus::kOk);
  EXPECT_EQ(result.messages.size(), 1U);
}

TEST(Hipe, IsDeterministicAndHasAFiniteCovariance) {
  SyntheticSite synthetic(13);
  const Evidence evidence = synthetic.Walk({{6, 6}, {42, 6}, {42, 30}}, 0.2, 4);
  const HipeEstimator hipe(HipeSolver::kFilter, {}, {}, {});
  const EstimateResult a = hipe.Estimate(synthetic.site, evidence);
  const EstimateResult b = hipe.Estimate(synthetic.site, evidence);
  ASSERT_EQ(a.trajectory.poses.size(), b.trajectory.poses.size());
  for (std::size_t i = 0; i < a.trajectory.poses.size(); ++i) {
    EXPECT_EQ(a.trajectory.poses[i].position_m, b.trajectory.poses[i].position_m);
    const Eigen::Matrix2d& covariance = a.trajectory.poses[i].covariance_xy_m2;
    EXPECT_TRUE(covariance.allFinite());
    EXPECT_GT(covariance.determinant(), 0);
  }
}

}  // namespace
}  // namespace walkgraph
