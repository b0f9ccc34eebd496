#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "frontends/radio_map/gaussian_process.h"

namespace walkgraph {
namespace {

// Of predictions' covariances, which are in single precision, to the process's variance.
constexpr double kKernelError = 2e-6;

double Covariance(const FieldPrior& prior, double distance_m) {
  const double r = std::numbers::sqrt3 * distance_m / prior.length_m;
  return prior.constant_sigma_db * prior.constant_sigma_db +
         prior.amplitude_db * prior.amplitude_db * (1.0 + r) * std::exp(-r);
}

struct Prediction {
  double mean_dbm = 0;
  double sigma_db = 0;
};

Prediction PredictAt(const FieldProcess& process, const Eigen::Vector2d& at) {
  Eigen::VectorXd mean, sigma;
  process.Predict(Eigen::Matrix2Xd(at), &mean, &sigma);
  return {mean(0), sigma(0)};
}

// Walks along lines 6 m apart; the last has a single sample.
std::vector<FieldSample> SomeSamples() {
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0.0, 4.0);
  std::vector<FieldSample> samples;
  for (std::uint32_t walk = 0; walk < 4; ++walk) {
    for (int i = 0; i < (walk == 3 ? 1 : 8); ++i) {
      const Eigen::Vector2d at(3.0 * i + 0.3 * walk, 6.0 * walk);
      samples.push_back({at, -60.0 - 0.8 * at.norm() + noise(random), walk, walk});
    }
  }
  return samples;
}

std::vector<FieldSample> Without(std::uint32_t walk, const std::vector<FieldSample>& samples) {
  std::vector<FieldSample> rest;
  for (const FieldSample& sample : samples) {
    if (sample.trial != walk) rest.push_back(sample);
  }
  return rest;
}

TEST(FieldProcessTest, OneSampleHasItsClosedForm) {
  const FieldPrior prior{10, 12, 4, -80, 10};
  const FieldProcess process({{{3, 4}, -55, 0}}, prior);
  const double own = Covariance(prior, 0.0) + 16.0;
  for (const double distance : {0.0, 2.5, 10.0, 35.0}) {
    const double cross = Covariance(prior, distance);
    const Prediction got = PredictAt(process, {3 + distance, 4});
    EXPECT_NEAR(got.mean_dbm, -80 + cross / own * 25, 25 * 244 * kKernelError / own);
    EXPECT_NEAR(got.sigma_db, std::sqrt(own - cross * cross / own), 2e-3);
  }
}

// The whole prediction by the textbook formulas, with the exact kernel and a plain inverse.
TEST(FieldProcessTest, AgreesWithTheTextbookFormulas) {
  const FieldPrior prior{7, 9, 3, -75, 8};
  const std::vector<FieldSample> samples = SomeSamples();
  const auto n = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd covariance(n, n);
  Eigen::VectorXd deviation(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    deviation(i) = samples[static_cast<std::size_t>(i)].rssi_dbm + 75;
    for (Eigen::Index j = 0; j < n; ++j) {
      const Eigen::Vector2d apart = samples[static_cast<std::size_t>(i)].position_m -
                                    samples[static_cast<std::size_t>(j)].position_m;
      covariance(i, j) = Covariance(prior, apart.norm()) + (i == j ? 9.0 : 0.0);
    }
  }
  const Eigen::MatrixXd inverse = covariance.inverse();
  const FieldProcess process(samples, prior);
  for (const Eigen::Vector2d& at :
       {Eigen::Vector2d(4, 3), Eigen::Vector2d(-5, 9), Eigen::Vector2d(40, 40)}) {
    Eigen::VectorXd cross(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      cross(i) = Covariance(prior, (samples[static_cast<std::size_t>(i)].position_m - at).norm());
    }
    const double variance = Covariance(prior, 0.0) - cross.dot(inverse * cross) + 9.0;
    const Prediction got = PredictAt(process, at);
    EXPECT_NEAR(got.mean_dbm, -75 + cross.dot(inverse * deviation), 0.01);
    EXPECT_NEAR(got.sigma_db, std::sqrt(variance), 0.01);
  }
}

// Readings beside the samples that they are part of, and one of a trial that has none.
TEST(FieldProcessTest, LeavingAWalkOutEqualsTrainingWithoutIt) {
  const FieldPrior prior{8, 10, 4, -78, 9};
  const std::vector<FieldSample> samples = SomeSamples();
  std::vector<FieldSample> readings = samples;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    readings[i].position_m += Eigen::Vector2d(1.1, -0.4) * (i % 3);
    readings[i].rssi_dbm += 1.5 * (i % 4) - 2;
  }
  readings.push_back({{7, 9}, -66, 9, 9});
  const Eigen::VectorXd whitened = FieldProcess(samples, prior).LeaveOneTrialOut(readings);
  ASSERT_EQ(whitened.size(), std::ssize(readings));
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const FieldProcess refit(Without(readings[i].trial, samples), prior);
    const Prediction expected = PredictAt(refit, readings[i].position_m);
    const double residual_db = readings[i].rssi_dbm - expected.mean_dbm;
    // The spread is predicted in single precision, the left-out ones in double.
    EXPECT_NEAR(whitened(static_cast<Eigen::Index>(i)), residual_db / expected.sigma_db, 2e-5);
  }
}

// The same to rounding, where the refit is done in double precision.
TEST(FieldProcessTest, LeavingAWalkOutIsExact) {
  const FieldPrior prior{6.4, 10, 4, -78, 9};
  const std::vector<double> places{0.0, 3.2, 12.8, 1.6, 9.6};
  const std::vector<std::uint32_t> walks{0, 0, 1, 2, 2};
  const std::vector<double> rssi{-60, -64, -71, -58, -75};
  std::vector<FieldSample> samples;
  for (std::size_t i = 0; i < places.size(); ++i) {
    samples.push_back({{places[i], 0}, rssi[i], walks[i], walks[i]});
  }
  const Eigen::VectorXd whitened = FieldProcess(samples, prior).LeaveOneTrialOut(samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    std::vector<std::size_t> kept;
    for (std::size_t j = 0; j < samples.size(); ++j) {
      if (walks[j] != walks[i]) kept.push_back(j);
    }
    const auto n = static_cast<Eigen::Index>(kept.size());
    Eigen::MatrixXd covariance(n, n);
    Eigen::VectorXd cross(n), deviation(n);
    for (Eigen::Index a = 0; a < n; ++a) {
      const std::size_t ka = kept[static_cast<std::size_t>(a)];
      cross(a) = Covariance(prior, std::abs(places[ka] - places[i]));
      deviation(a) = rssi[ka] + 78;
      for (Eigen::Index b = 0; b < n; ++b) {
        const std::size_t kb = kept[static_cast<std::size_t>(b)];
        covariance(a, b) = Covariance(prior, std::abs(places[ka] - places[kb])) + 16.0 * (a == b);
      }
    }
    const Eigen::VectorXd gain = covariance.fullPivLu().solve(cross);
    const double sigma_db = std::sqrt(Covariance(prior, 0) + 16 - gain.dot(cross));
    const double residual_db = rssi[i] + 78 - gain.dot(deviation);
    EXPECT_NEAR(whitened(static_cast<Eigen::Index>(i)), residual_db / sigma_db, 1e-8);
  }
}

TEST(FieldProcessTest, ASingleWalkLeftOutIsJudgedByThePrior) {
  const FieldPrior prior{8, 10, 4, -78, 9};
  const std::vector<FieldSample> samples{{{0, 0}, -60, 5, 5}, {{2, 0}, -70, 5, 5}};
  const double sigma_db = std::sqrt(81.0 + 100.0 + 16.0);
  const Eigen::VectorXd whitened = FieldProcess(samples, prior).LeaveOneTrialOut(samples);
  EXPECT_NEAR(whitened[0], 18 / sigma_db, 1e-9);
  EXPECT_NEAR(whitened[1], 8 / sigma_db, 1e-9);
}

TEST(FieldProcessTest, FarAwayOnlyTheConstantIsKnown) {
  const FieldPrior prior;
  const FieldProcess process(SomeSamples(), prior);
  for (const Eigen::Vector2d& at : {Eigen::Vector2d(400, 0), Eigen::Vector2d(-300, 1e6)}) {
    const Prediction far = PredictAt(process, at);
    EXPECT_NEAR(far.mean_dbm, process.far_mean_dbm(), 1e-4);
    EXPECT_NEAR(far.sigma_db, process.far_sigma_db(), 1e-4);
  }
  // Less than before any sample was seen, more than the field's own amplitude and the noise.
  EXPECT_LT(process.far_sigma_db(), std::sqrt(100.0 + 144.0 + 16.0));
  EXPECT_GT(process.far_sigma_db(), std::sqrt(144.0 + 16.0));
}

TEST(FieldProcessTest, SpreadGrowsAwayFromTheSamples) {
  const FieldProcess process({{{0, 0}, -50, 0}, {{1, 0}, -52, 0}, {{0, 1}, -51, 1}}, {});
  double last_db = 4.0;  // never below the noise
  for (const double distance_m : {1.0, 4.0, 8.0, 16.0, 32.0, 64.0}) {
    const double sigma_db = PredictAt(process, {-distance_m, 0}).sigma_db;
    EXPECT_GT(sigma_db, last_db + 0.01) << distance_m;
    last_db = sigma_db;
  }
  EXPECT_LE(last_db, process.far_sigma_db() + 1e-6);
  EXPECT_GT(last_db, 12.0);
}

TEST(FieldProcessTest, ManySamplesOfOnePlaceLeaveTheNoise) {
  const FieldPrior prior;
  const FieldProcess process(std::vector<FieldSample>(200, {{5, 5}, -63, 0}), prior);
  const Prediction there = PredictAt(process, {5, 5});
  EXPECT_NEAR(there.mean_dbm, -63, 0.02);
  EXPECT_NEAR(there.sigma_db, std::sqrt(16.0 + 16.0 / 200.0), 0.01);
}

TEST(FieldProcessTest, KernelStaysWithinItsBound) {
  const FieldPrior prior{13.7, 12, 4, -80, 10};
  const FieldProcess process({{{0, 0}, -30, 0}}, prior);
  const double own = Covariance(prior, 0) + 16;
  for (double distance_m = 0; distance_m < 14 * prior.length_m; distance_m += 0.0371) {
    const double got = (PredictAt(process, {distance_m, 0}).mean_dbm + 80) * own / 50;
    ASSERT_NEAR(got, Covariance(prior, distance_m), 244 * kKernelError);
  }
}

}  // namespace
}  // namespace walkgraph
