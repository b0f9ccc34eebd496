#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "frontends/radio_map/gaussian_process.h"
#include "frontends/radio_map/map_builder.h"
#include "frontends/radio_map/site_file.h"
#include "frontends/radio_map/trainer.h"
#include "frontends/radio_world.h"

namespace walkgraph {
namespace {

const RadioMap& OnlyMap(const Site& site) {
  EXPECT_EQ(site.maps.size(), 1U);
  return site.maps.front();
}

// Visits a grid of places over the hall up to x = width_m that no survey walk's sample stands on.
template <typename F>
void ForPlaces(double width_m, F&& visit) {
  for (double x = 1.3; x < width_m; x += 2.6) {
    for (double y = 1.1; y < RadioWorld::kHeightM; y += 1.9) visit(Eigen::Vector2d(x, y));
  }
}

TEST(TrainSiteTest, LearnsThePathLossOfTheHall) {
  RadioWorld world(1);
  const Site site = TrainSite(world.building, world.Survey(3.0), {});
  const RadioMap& map = OnlyMap(site);
  double error_db = 0, heard_error = 0, whitened = 0;
  int count = 0, places = 0;
  ForPlaces(RadioWorld::kWidthM, [&](const Eigen::Vector2d& at) {
    const FieldBasis basis = EvaluateBasis(map.grid, at);
    for (std::size_t i = 0; i < map.fields.size(); ++i) {
      const std::size_t transmitter = map.fields[i].transmitter;
      const FieldValue value = map.EvaluateValue(static_cast<int>(i), basis);
      const double hear = RadioWorld::HearProbability(world.MeanDbm(transmitter, at));
      heard_error += std::abs(1 / (1 + std::exp(-value.logit_hear)) - hear);
      ++places;
      if (hear < 0.5) continue;
      error_db += std::abs(value.mean_dbm - world.MeanDbm(transmitter, at));
      const double fresh_dbm = world.ReadingDbm(transmitter, at);
      whitened += std::pow((fresh_dbm - value.mean_dbm) / std::exp(value.log_sigma), 2);
      ++count;
    }
  });
  ASSERT_GT(count, 500);
  EXPECT_LT(error_db / count, 2.5);
  EXPECT_LT(heard_error / places, 0.12);
  // Fresh readings deviate by what the map says.
  EXPECT_NEAR(std::sqrt(whitened / count), 1.0, 0.15);
}

TEST(TrainSiteTest, SpreadGrowsAwayFromTheSurvey) {
  RadioWorld world(2, 6, 20.0);
  const Site site = TrainSite(world.building, world.Survey(3.0, 20.0), {});
  const RadioMap& map = OnlyMap(site);
  for (std::size_t i = 0; i < map.fields.size(); ++i) {
    const auto sigma_db = [&](double x) {
      const FieldBasis basis = EvaluateBasis(map.grid, {x, 12.0});
      return std::exp(map.EvaluateValue(static_cast<int>(i), basis).log_sigma);
    };
    EXPECT_LT(sigma_db(10), 0.6 * sigma_db(32));
    EXPECT_LT(sigma_db(25), sigma_db(28));
    EXPECT_LT(sigma_db(28), sigma_db(55));
    EXPECT_GE(sigma_db(10), map.sigma_min_db);
  }
}

// Readings from inside, off the map by half a dozen dB as another phone's would be. Where nothing
// was surveyed any reading fits a wide spread: the whitened residuals alone flee there, the whole
// -log p does not.
TEST(TrainSiteTest, TheOptimumCannotFleeToWhereTheMapKnowsNothing) {
  constexpr double kSurveyedM = 20;
  RadioWorld world(3, 8, kSurveyedM);
  const Site site = TrainSite(world.building, world.Survey(3.0, kSurveyedM), {});
  const RadioMap& map = OnlyMap(site);
  const Eigen::Vector2d truth(9, 11);
  double best_full = std::numeric_limits<double>::infinity(), best_residual = best_full;
  Eigen::Vector2d at_full, at_residual;
  for (double x = 0; x <= RadioWorld::kWidthM; x += 0.5) {
    for (double y = 0; y <= RadioWorld::kHeightM; y += 0.5) {
      const FieldBasis basis = EvaluateBasis(map.grid, {x, y});
      double residual = 0, full = map.Silence(basis).value;
      for (std::size_t i = 0; i < map.fields.size(); ++i) {
        const double off_db = i % 2 == 0 ? 7.0 : -7.0;
        const double rssi_dbm = world.MeanDbm(map.fields[i].transmitter, truth) + off_db;
        const FieldValue value = map.EvaluateValue(static_cast<int>(i), basis);
        const double z = (rssi_dbm - value.mean_dbm) / std::exp(value.log_sigma);
        residual += 0.5 * z * z;
        full += 0.5 * z * z + value.log_sigma - value.logit_hear;
      }
      if (residual < best_residual) {
        best_residual = residual;
        at_residual = {x, y};
      }
      if (full < best_full) {
        best_full = full;
        at_full = {x, y};
      }
    }
  }
  EXPECT_GT(at_residual.x(), kSurveyedM) << "the temptation that the test is about is gone";
  EXPECT_LT(at_full.x(), kSurveyedM);
  EXPECT_LT((at_full - truth).norm(), 8.0);
}

TEST(TrainSiteTest, EqualInputGivesEqualBytes) {
  const auto train = [] {
    RadioWorld world(4, 6);
    return SerializeSite(TrainSite(world.building, world.Survey(3.0), {}));
  };
  EXPECT_EQ(train(), train());
}

// The parts of training hand nothing on to each other: last first gives the same bytes.
TEST(TrainSiteTest, HangsNotOnTheOrderInWhichItsPartsAreRun) {
  std::size_t runs = 0;
  const Executor backwards = [&](std::size_t count, const std::function<void(std::size_t)>& job) {
    ++runs;
    for (std::size_t i = count; i-- > 0;) job(i);
  };
  RadioWorld world(4, 6);
  const std::vector<SurveyWalk> walks = world.Survey(3.0);
  const std::string in_order = SerializeSite(TrainSite(world.building, walks, {}));
  EXPECT_EQ(SerializeSite(TrainSite(world.building, walks, {}, backwards)), in_order);
  EXPECT_GT(runs, 10U);
}

// A dense survey in clear air is off by a fraction of a metre; one whose walks are each put down
// metres from where they went must be believed less.
TEST(TrainSiteTest, CalibratesTheErrorThatScansShare) {
  RadioWorld exact(5), displaced(5);
  const Site good = TrainSite(exact.building, exact.Survey(1.5), {});
  const Site bad = TrainSite(displaced.building, displaced.Survey(1.5, 60.0, 5.0), {});
  EXPECT_LT(OnlyMap(good).map_error_sigma_m, 0.7);
  EXPECT_GT(OnlyMap(bad).map_error_sigma_m, 2.0);
  EXPECT_GT(OnlyMap(good).n_eff, 0);
}

TEST(TrainSiteTest, NoSurveyGivesASiteWithoutMaps) {
  const RadioWorld world(6);
  const Site site = TrainSite(world.building, {}, {});
  EXPECT_TRUE(site.maps.empty());
  EXPECT_TRUE(site.transmitters.empty());
  EXPECT_TRUE(site.SurveyedFloors().empty());
  EXPECT_EQ(site.building.floors.size(), 1U);
}

TEST(TrainSiteTest, WalksWithoutReadingsAddOnlyTheirPath) {
  RadioWorld world(7, 5);
  std::vector<SurveyWalk> walks = world.Survey(6.0);
  const Site before = TrainSite(world.building, walks, {});
  Evidence silent;
  silent.begin_ns = walks[0].evidence->begin_ns;
  silent.end_ns = walks[0].evidence->end_ns;
  walks.push_back({&silent, walks[0].trajectory});
  Site after = TrainSite(world.building, walks, {});
  EXPECT_GT(after.path.size(), before.path.size());
  after.path = before.path;
  EXPECT_EQ(SerializeSite(after), SerializeSite(before));
  walks = {{&silent, walks[0].trajectory}};
  EXPECT_TRUE(TrainSite(world.building, walks, {}).maps.empty());
}

TEST(TrainSiteTest, WalksWithoutATrajectoryAddNothing) {
  RadioWorld world(8, 5);
  std::vector<SurveyWalk> walks = world.Survey(6.0);
  const Site before = TrainSite(world.building, walks, {});
  Evidence lost = *walks[0].evidence;
  for (Transmitter& transmitter : lost.transmitters) transmitter.name += "_elsewhere";
  walks.push_back({&lost, Trajectory()});
  EXPECT_EQ(SerializeSite(TrainSite(world.building, walks, {})), SerializeSite(before));
}

TEST(TrainSiteTest, OneWalkIsEnoughForAMap) {
  RadioWorld world(9, 5);
  const Site site = TrainSite(world.building, {world.Walk({2, 12}, {40, 12})}, {});
  const RadioMap& map = OnlyMap(site);
  EXPECT_GT(map.n_eff, 0);
  EXPECT_GT(map.map_error_sigma_m, 0);
  EXPECT_GT(map.sigma_min_db, 0);
  ForPlaces(RadioWorld::kWidthM, [&](const Eigen::Vector2d& at) {
    const FieldBasis basis = EvaluateBasis(map.grid, at);
    EXPECT_TRUE(std::isfinite(map.Silence(basis).value));
    for (std::size_t i = 0; i < map.fields.size(); ++i) {
      const FieldValue value = map.EvaluateValue(static_cast<int>(i), basis);
      EXPECT_TRUE(std::isfinite(value.mean_dbm) && std::isfinite(value.log_sigma));
    }
  });
}

TEST(TrainSiteTest, ReadingsFromOutsideTheKnownTimesAreNotPlaced) {
  RadioWorld world(10, 3);
  SurveyWalk walk = world.Walk({2, 12}, {30, 12});
  Evidence evidence = *walk.evidence;
  const std::size_t placed = evidence.readings.size();
  evidence.readings.push_back(
      {evidence.end_ns + 5 * kNsPerSecond, evidence.end_ns + 5 * kNsPerSecond, 0, -30});
  walk.evidence = &evidence;
  const Site site = TrainSite(world.building, {walk}, {});
  std::size_t readings = 0;
  for (const SurveyScan& scan : site.scans) readings += scan.readings.size();
  EXPECT_EQ(readings, placed);
}

TEST(TrainSiteTest, FloorsAndRadiosHaveMapsOfTheirOwn) {
  RadioWorld world(11, 4);
  std::vector<SurveyWalk> walks = world.Survey(8.0);
  for (PoseEstimate& pose : walks[0].trajectory.poses) pose.floor = 3;
  Evidence beacons = *walks[1].evidence;
  for (Transmitter& transmitter : beacons.transmitters) transmitter.radio = Radio::kBeacon;
  walks[1].evidence = &beacons;
  const Site site = TrainSite(world.building, walks, {});
  EXPECT_EQ(site.SurveyedFloors(), (std::vector<int>{0, 3}));
  ASSERT_EQ(site.maps.size(), 3U);
  EXPECT_NE(site.FindMap(0, Radio::kBeacon), nullptr);
  EXPECT_NE(site.FindMap(3, Radio::kWifi), nullptr);
  EXPECT_EQ(site.FindMap(3, Radio::kBeacon), nullptr);
  EXPECT_EQ(site.transmitters.size(), 8U);
}

// One scan of one transmitter.
SurveyScan ScanOf(std::uint32_t walk, const Eigen::Vector2d& at, double rssi_dbm,
                  std::uint32_t transmitter = 0) {
  SurveyScan scan;
  scan.walk = scan.trial = walk;
  scan.readings = {{transmitter, static_cast<float>(rssi_dbm), 0, at.cast<float>()}};
  return scan;
}

double SigmaScaleOf(const std::vector<SurveyScan>& scans, const FieldPrior& prior) {
  ScanList list;
  for (const SurveyScan& scan : scans) list.push_back(&scan);
  return LeftOutSigmaScale(list, TrainerSettings(), prior);
}

// Two walks along one line whose readings scatter twice as much as the prior's noise.
TEST(LeftOutSigmaScaleTest, GrowsWithTheScatterOfTheReadings) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  FieldPrior prior;
  prior.amplitude_db = 0.01;
  const auto scale_of = [&](double noise_db) {
    std::vector<SurveyScan> scans;
    for (std::uint32_t i = 0; i < 400; ++i) {
      scans.push_back(ScanOf(i % 2, {4.0 * (i / 2), 0}, -70 + noise_db * normal(random)));
    }
    return SigmaScaleOf(scans, prior);
  };
  EXPECT_NEAR(scale_of(prior.noise_db), 1.0, 0.15);
  EXPECT_NEAR(scale_of(2 * prior.noise_db), 2.0, 0.3);
}

TEST(LeftOutSigmaScaleTest, IsOneWhereNoWalksShareATransmitter) {
  std::vector<SurveyScan> scans;
  for (std::uint32_t i = 0; i < 40; ++i) scans.push_back(ScanOf(i % 2, {1.0 * i, 1}, -40, i % 2));
  EXPECT_EQ(SigmaScaleOf(scans, {}), 1.0);
  EXPECT_EQ(SigmaScaleOf({}, {}), 1.0);
}

// Samples that average many readings are better than a single one, but it is single ones that a
// map's spread is held against.
TEST(LeftOutSigmaScaleTest, IsThatOfSingleReadingsHoweverManyMakeASample) {
  constexpr double kNoiseDb = 6;
  constexpr int kReadingsPerPlace = 10;
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0, kNoiseDb);
  std::vector<SurveyScan> scans;
  for (std::uint32_t walk = 0; walk < 6; ++walk) {
    for (int i = 0; i < 40 * kReadingsPerPlace; ++i) {
      scans.push_back(ScanOf(walk, {3.0 * (i / kReadingsPerPlace), 0}, -60 + noise(random)));
    }
  }
  ScanList list;
  for (const SurveyScan& scan : scans) list.push_back(&scan);
  const auto samples = CollectSamples(list, TrainerSettings());
  ASSERT_EQ(samples.at(0).size(), 6u * 40u);
  FieldPrior prior;
  prior.amplitude_db = 1;
  prior.noise_db = kNoiseDb / std::sqrt(kReadingsPerPlace);
  Eigen::VectorXd mean_dbm, sigma_db;
  FieldProcess(samples.at(0), prior).Predict(Eigen::Vector2d(30, 0), &mean_dbm, &sigma_db);
  EXPECT_NEAR(SigmaScaleOf(scans, prior) * sigma_db[0], kNoiseDb, 0.15 * kNoiseDb);
}

// Walks past a transmitter, where a sample's three metres are several dB wide. The field knows the
// slope, so that only the noise is left.
TEST(LeftOutSigmaScaleTest, ASlopeAcrossASampleIsNoNoise) {
  constexpr double kNoiseDb = 1, kSlopeDbPerM = 5;
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, kNoiseDb);
  std::vector<SurveyScan> scans;
  for (std::uint32_t walk = 0; walk < 4; ++walk) {
    for (int i = 0; i < 60; ++i) {
      const double x_m = 0.5 * i + 0.1 * walk;
      scans.push_back(ScanOf(walk, {x_m, 0}, -100 + kSlopeDbPerM * x_m + noise(random)));
    }
  }
  FieldPrior prior;
  prior.length_m = 20;
  prior.amplitude_db = 60;
  prior.noise_db = kNoiseDb;
  EXPECT_LT(SigmaScaleOf(scans, prior), 1.2);
}

TEST(CoveringGridTest, TheBoxAndThePathLieInsideTheSpline) {
  Floor floor;
  floor.min_corner = {-3, 2};
  floor.max_corner = {41.5, 33};
  const std::vector<SurveyPoint> path{{{60, -7}, 1, 0}, {{500, 500}, 2, 0}};
  const FieldGrid grid = CoveringGrid(&floor, path, 1, {});
  for (const Eigen::Vector2d& corner : {Eigen::Vector2d(-3, -7), Eigen::Vector2d(60, 33)}) {
    const Eigen::Vector2d at = (corner - grid.origin_m) / grid.spacing_m;
    EXPECT_GE(at.minCoeff(), 1.0);
    EXPECT_LE(at.x(), grid.columns - 2.0);
    EXPECT_LE(at.y(), grid.rows - 2.0);
  }
  EXPECT_LT(grid.columns, 30);  // the other floor's path does not count
}

TEST(CollectSamplesTest, MergesNeighboursOfOneWalkOnly) {
  SurveyScan first{0, 0, 0, 0, Radio::kWifi, {}}, second{0, 1, 1, 0, Radio::kWifi, {}};
  first.readings = {{7, -60, 0, {6.0F, 6.1F}}, {7, -70, 0, {6.4F, 5.9F}}, {7, -50, 0, {20, 6}}};
  second.readings = {{7, -80, 0, {6.0F, 6.0F}}};
  const auto samples = CollectSamples({&first, &second}, {});
  ASSERT_EQ(samples.size(), 1U);
  const std::vector<FieldSample>& list = samples.at(7);
  ASSERT_EQ(list.size(), 3U);
  EXPECT_NEAR(list[0].rssi_dbm, -65, 1e-6);
  EXPECT_LT((list[0].position_m - Eigen::Vector2d(6.2, 6.0)).norm(), 1e-6);
}

}  // namespace
}  // namespace walkgraph
