#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "solvers/baselines/mufaf/cell_map.h"
#include "solvers/baselines/mufaf/kriging.h"
#include "solvers/baselines/mufaf/map_update.h"
#include "solvers/baselines/mufaf/tracking.h"

namespace walkgraph {
namespace {

using Scalar = Eigen::Matrix<double, 1, 1>;

// Cells on the x axis with one anchor.
CellMap Line(const std::vector<std::pair<double, double>>& at_and_mean) {
  CellMap map(1);
  for (const auto& [x, mean] : at_and_mean) {
    map.AddCell({x, 0}, Scalar(mean), Scalar(4), 10);
  }
  return map;
}

TEST(CellMap, ExponentialRegressionWeighsByDistanceInDecibels) {
  const CellMap map = Line({{0, -64}, {1, -66}});
  EXPECT_NEAR(EstimatePosition(map, Scalar(-60), {}).x(), 0.0758582, 5e-8);
}

TEST(CellMap, EstimatorsAgreeWithTheirDefinitions) {
  const CellMap map = Line({{0, -50}, {1, -60}, {2, -70}, {3, -80}});
  CellEstimatorSettings settings;
  settings.estimator = CellEstimator::kGaussian;
  settings.bandwidth_db = 5;
  double sum = 0, weights = 0;
  for (int c = 0; c < 4; ++c) {
    const double d = (-62 + 50 + 10 * c) / 5.0;
    sum += c * std::exp(-0.5 * d * d);
    weights += std::exp(-0.5 * d * d);
  }
  EXPECT_NEAR(EstimatePosition(map, Scalar(-62), settings).x(), sum / weights, 1e-12);
  settings.estimator = CellEstimator::kNearestNeighbours;
  settings.neighbours = 3;
  EXPECT_NEAR(EstimatePosition(map, Scalar(-62), settings).x(), 1, 1e-12);
  settings.estimator = CellEstimator::kEuclidean;
  EXPECT_NEAR(EstimatePosition(map, Scalar(-68), settings).x(), 2, 1e-12);
  EXPECT_NEAR(EstimatePosition(map, Scalar(-68), settings, 2).x(), 1, 1e-12);  // left out
}

TEST(CellMap, MahalanobisTrustsTheSteadyAnchor) {
  CellMap map(2);
  map.AddCell({0, 0}, Eigen::Vector2d(-50, -60), Eigen::Vector2d(1, 100), 5);
  map.AddCell({1, 0}, Eigen::Vector2d(-54, -70), Eigen::Vector2d(1, 100), 5);
  CellEstimatorSettings settings;
  settings.estimator = CellEstimator::kMahalanobis;
  const Eigen::Vector2d heard(-50.5, -70);
  EXPECT_EQ(EstimatePosition(map, heard, settings).x(), 0);
  settings.estimator = CellEstimator::kEuclidean;
  EXPECT_EQ(EstimatePosition(map, heard, settings).x(), 1);
}

TEST(CellMap, KernelsFarFromEveryCellStayFinite) {
  const CellMap map = Line({{0, -64}, {1, -66}});
  CellEstimatorSettings settings;
  settings.estimator = CellEstimator::kGaussian;
  EXPECT_NEAR(EstimatePosition(map, Scalar(-1000), settings).x(), 1, 1e-9);
}

TEST(CellMap, NewSamplesMoveTheMean) {
  CellMap map = Line({{0, -60}, {1, -70}});
  map.AddSample(0, Scalar(-71), 0);
  EXPECT_NEAR(map.mean_dbm()(0, 0), -61, 1e-12);  // the eleventh sample
  EXPECT_EQ(map.NearestCell({0.6, 3}), 1);
}

// A transmitter that lost 10 dB: a cell that keeps its ten old samples is 5 dB behind after ten new
// ones, one that remembers four has all but forgotten them.
TEST(CellMap, AMemoryForgets) {
  CellMap keeps = Line({{0, -60}, {1, -70}}), forgets = keeps;
  for (int i = 0; i < 10; ++i) {
    keeps.AddSample(0, Scalar(-70), 0);
    forgets.AddSample(0, Scalar(-70), 4);
  }
  EXPECT_NEAR(keeps.mean_dbm()(0, 0), -65, 1e-12);
  EXPECT_NEAR(forgets.mean_dbm()(0, 0), -70 + 10 * std::pow(0.75, 10), 1e-12);
  EXPECT_EQ(forgets.mean_dbm()(0, 1), -70);
}

TEST(SphericalVariogram, KrigingOfTwoData) {
  const SphericalVariogram variogram{0, 1, 10};
  const Interpolated result =
      OrdinaryKriging(variogram, {{0, 0}, {4, 0}}, Eigen::Vector2d(3, 7), {1, 0});
  EXPECT_NEAR(result.weights(0), 0.752641, 5e-7);
  EXPECT_NEAR(result.weights(1), 0.247359, 5e-7);
  EXPECT_NEAR(result.multiplier, 0.009, 5e-7);
  EXPECT_NEAR(result.variance, 0.229492, 5e-7);
  EXPECT_NEAR(result.value, 3 + 4 * 0.247359, 5e-6);
}

TEST(SphericalVariogram, KrigingInTheMiddleOfASquare) {
  const std::vector<Eigen::Vector2d> square{{0, 0}, {2, 0}, {0, 2}, {2, 2}};
  const Interpolated result =
      OrdinaryKriging({0, 1, 10}, square, Eigen::Vector4d(1, 2, 3, 4), {1, 1});
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(result.weights(i), 0.25, 1e-12);
  EXPECT_NEAR(result.variance, 0.170198, 5e-7);
  EXPECT_NEAR(OrdinaryKriging({1, 0, 10}, square, Eigen::Vector4d(1, 2, 3, 4), {1, 1}).variance,
              1.25, 1e-12);
}

TEST(SphericalVariogram, KrigingAtADatumReturnsItAndKeepsConstants) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> at(0, 20);
  std::vector<Eigen::Vector2d> places;
  Eigen::VectorXd values(7);
  for (int i = 0; i < 7; ++i) {
    const double x = at(random), y = at(random);
    places.emplace_back(x, y);
    values(i) = at(random);
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Interpolated there = OrdinaryKriging({0, 4, 12}, places, values, places[i]);
    EXPECT_NEAR(there.value, values(static_cast<Eigen::Index>(i)), 1e-9);
    EXPECT_NEAR(there.variance, 0, 1e-9);
  }
  const Eigen::VectorXd constant = Eigen::VectorXd::Constant(7, -63);
  EXPECT_NEAR(OrdinaryKriging({0.5, 4, 12}, places, constant, {9, 9}).value, -63, 1e-9);
  EXPECT_NEAR(OrdinaryKriging({0.5, 4, 12}, places, values, {9, 9}).weights.sum(), 1, 1e-12);
}

// Far from the data the covariance method falls back to its mean, kriging to that of the data.
TEST(SphericalVariogram, CovarianceInterpolationLeansOnItsMean) {
  const std::vector<Eigen::Vector2d> places{{0, 0}, {1, 0}};
  const Eigen::Vector2d values(-50, -52);
  EXPECT_NEAR(CovarianceInterpolation({0, 1, 5}, -70, places, values, {100, 0}).value, -70, 1e-12);
  EXPECT_NEAR(CovarianceInterpolation({0, 1, 5}, -70, places, values, {1, 0}).value, -52, 1e-9);
  EXPECT_NEAR(OrdinaryKriging({0, 1, 5}, places, values, {100, 0}).value, -51, 1e-9);
}

TEST(SphericalVariogram, FitFindsTheModelThatMadeTheMeasurements) {
  const SphericalVariogram truth{1.5, 6, 9};
  EmpiricalVariogram measured;
  for (double h = 0.5; h < 15; h += 0.5) {
    measured.distance_m.push_back(h);
    measured.gamma.push_back(truth(h));
    measured.pairs.push_back(20);
  }
  const SphericalVariogram fit = FitSpherical(measured);
  EXPECT_NEAR(fit.nugget, 1.5, 0.3);
  EXPECT_NEAR(fit.Sill(), 7.5, 0.1);
  EXPECT_NEAR(fit.range_m, 9, 0.8);
}

TEST(SphericalVariogram, MeasuresHalfTheMeanSquaredDifference) {
  // Three places a metre apart: pairs at 1 m differ by 2 and 4, that at 2 m lies beyond half way.
  const EmpiricalVariogram measured =
      MeasureVariogram({{0, 0}, {1, 0}, {2, 0}, {3.9, 0}}, Eigen::Vector4d(1, 3, 7, 7), 1);
  ASSERT_EQ(measured.gamma.size(), 1U);
  EXPECT_NEAR(measured.gamma[0], (4 + 16 + 0) / 2.0 / 3, 1e-12);
}

TEST(AlphaBetaFilter, HasTheGainsAndLagsOfTheory) {
  AlphaBetaFilter speed(0.3), acceleration(0.3);
  EXPECT_NEAR(speed.beta(), 0.052941, 5e-7);
  const double dt = 0.5, v = 1.3, a = 0.2;
  Eigen::Vector2d lag_v, lag_a;
  for (int k = 0; k < 600; ++k) {
    const double t = k * dt;
    const Eigen::Vector2d at_v(v * t, 0), at_a(a * t * t / 2, 0);
    lag_v = at_v - speed.Advance(at_v, dt);
    lag_a = at_a - acceleration.Advance(at_a, dt);
  }
  EXPECT_NEAR(lag_v.x(), 0, 1e-9);
  EXPECT_NEAR(lag_a.x(), 13.2222 * a * dt * dt, 1e-4);
}

TEST(AlphaBetaFilter, LetsThroughTheNoiseOfTheory) {
  AlphaBetaFilter filter(0.3);
  std::mt19937 random(8);
  std::normal_distribution<double> noise(0, 1);
  double sum = 0;
  constexpr int kSamples = 400'000;
  for (int k = 0; k < kSamples; ++k) {
    const double x = noise(random);
    const double out = filter.Advance({x, 0}, 1).x();
    sum += out * out / kSamples;
  }
  EXPECT_NEAR(sum, 0.237258, 0.006);
}

TEST(AlphaBetaFilter, RefusesToBeUnstable) {
  EXPECT_THROW(AlphaBetaFilter(0), std::invalid_argument);
  EXPECT_THROW(AlphaBetaFilter(1), std::invalid_argument);
}

TEST(Tracking, SteadyStateOfOneRadio) {
  const ConstantVelocity model;
  KalmanState<4> state = BeginTrack({{0, 0}, 1});
  for (int k = 0; k < 60; ++k) {
    state = model.Predict(state, 1);
    if (k == 59) {
      Eigen::Matrix<double, 2, 4> c = Eigen::Matrix<double, 2, 4>::Zero();
      c.leftCols<2>().setIdentity();
      const auto gain = KalmanGain<4, 2>(state, c, Eigen::Matrix2d::Identity());
      EXPECT_NEAR(gain(0, 0), 0.75, 1e-9);
      EXPECT_NEAR(gain(2, 0), 0.5, 1e-9);
    }
    state = UpdateTrack(state, {{{0, 0}, 1}});
  }
  EXPECT_NEAR(state.covariance(0, 0), 0.75, 1e-9);
}

TEST(Tracking, InputPushesEveryWalkAside) {
  ConstantVelocity model;
  model.input_mps2 = 0.1;
  KalmanState<4> state = BeginTrack({{0, 0}, 1});
  for (int k = 0; k < 100; ++k) state = UpdateTrack(model.Predict(state, 1), {{{0, 0}, 1}});
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(state.mean(axis), 0.05, 1e-9);
    EXPECT_NEAR(state.mean(2 + axis), 0.10, 1e-9);
  }
}

KalmanState<1> Fix(KalmanState<1> state, const std::vector<double>& fixes, double variance) {
  for (const double fix : fixes) {
    state = KalmanUpdate<1, 1>(state, Scalar(fix - state.mean(0)), Scalar(1), Scalar(variance));
  }
  return state;
}

TEST(Tracking, TrackFusionCountsThePriorTwice) {
  const KalmanState<1> prior{Scalar(0), Scalar(100)};
  EXPECT_NEAR(Fix(prior, {1, 1}, 4).covariance(0), 1.96078, 5e-6);  // stacked
  EXPECT_NEAR(FuseTracks<1>({Fix(prior, {1}, 4), Fix(prior, {1}, 4)}).covariance(0), 1.92308, 5e-6);
}

// Two filters of one random walk: their errors share its steps, which the fusion does not know.
TEST(Tracking, TrackFusionIsOverconfidentUnderProcessNoise) {
  std::mt19937 random(9);
  std::normal_distribution<double> unit(0, 1);
  KalmanState<1> a{Scalar(0), Scalar(4)}, b = a, fused = a;
  double truth = 0, squares = 0;
  constexpr int kSteps = 200'000;
  for (int k = 0; k < kSteps; ++k) {
    truth += unit(random);
    for (KalmanState<1>* track : {&a, &b}) {
      *track = KalmanPredict<1>(*track, Scalar(1), Scalar(0), Scalar(1));
      const double measured = truth + 2 * unit(random);
      *track = Fix(*track, {measured}, 4);
    }
    fused = FuseTracks<1>({a, b});
    squares += (fused.mean(0) - truth) * (fused.mean(0) - truth) / kSteps;
  }
  EXPECT_NEAR(fused.covariance(0), 0.78078, 5e-6);
  EXPECT_NEAR(squares, 1.07648, 0.02);
}

TEST(Tracking, GroupFusionOfAllRadiosIsOneStackedUpdate) {
  const KalmanState<4> begun = BeginTrack({{1, 2}, 3});
  const RadioFix one{{2, 3}, 2}, two{{0, 1}, 4};
  const KalmanState<4> stacked = UpdateTrack(begun, {one, two});
  const KalmanState<4> by_turns = UpdateTrack(UpdateTrack(begun, {one}), {two});
  EXPECT_TRUE(stacked.mean.isApprox(by_turns.mean, 1e-12));
  EXPECT_TRUE(stacked.covariance.isApprox(by_turns.covariance, 1e-12));
}

// A plane of signals on 5 x 5 cells.
CellMap Plane(double shift_db) {
  CellMap map(2);
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 5; ++y) {
      const Eigen::Vector2d at(2 * x, 2 * y);
      map.AddCell(at, Eigen::Vector2d(-50 - at.x() + shift_db, -50 - at.y() + shift_db),
                  Eigen::Vector2d(4, 4), 5);
    }
  }
  return map;
}

TEST(AdaptiveCellMap, KrigesWhatLiesBetweenTheCells) {
  const AdaptiveCellMap map(Plane(0), {});
  const Eigen::VectorXd there = map.SignalsAt({3, 5});
  EXPECT_NEAR(there(0), -53, 0.5);
  EXPECT_NEAR(there(1), -55, 0.5);
}

TEST(AdaptiveCellMap, TakesWhatFitsAndRefusesWhatDoesNot) {
  AdaptiveCellMap map(Plane(0), {});
  EXPECT_TRUE(map.Offer({4, 4}, Eigen::Vector2d(-54.5, -54.5)));
  EXPECT_FALSE(map.Offer({4, 4}, Eigen::Vector2d(-58, -58)));
  const Eigen::Index cell = map.map().NearestCell({4, 4});
  EXPECT_NEAR(map.map().mean_dbm()(0, cell), -54 - 0.5 / 6, 1e-12);
}

// As printed, the update stores the map's own value: at a cell without nugget it changes nothing.
TEST(AdaptiveCellMap, StoringTheKrigedValueBringsNothingNew) {
  MapUpdateSettings settings;
  settings.store = StoreRule::kKriged;
  settings.threshold_db = 10;
  AdaptiveCellMap map(Plane(0), settings);
  const Eigen::MatrixXd before = map.map().mean_dbm();
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(map.Offer({4, 4}, Eigen::Vector2d(-57, -57)));
  }
  EXPECT_NEAR((map.map().mean_dbm() - before).norm(), 0, 0.3);
  settings.store = StoreRule::kObserved;
  AdaptiveCellMap learning(Plane(0), settings);
  for (int i = 0; i < 20; ++i) learning.Offer({4, 4}, Eigen::Vector2d(-57, -57));
  EXPECT_GT((learning.map().mean_dbm() - before).norm(), 3);
}

}  // namespace
}  // namespace walkgraph
