#include "solvers/baselines/likelihood_grid.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "frontends/radio_map/body_shadow.h"
#include "solvers/baselines/sweep_costs.h"
#include "solvers/synthetic_site.h"

namespace walkgraph {
namespace {

using testing::SyntheticSite;

TEST(CollectMapSweeps, WeighsAScanByItsEffectiveReadings) {
  SyntheticSite synthetic(1);
  const Evidence evidence = synthetic.Walk({{10, 10}, {30, 10}}, 0.1, 4);
  const RadioMap& map = synthetic.site.maps.front();
  const auto sweeps = CollectMapSweeps(synthetic.site, map, evidence, FingerprintSettings());
  ASSERT_EQ(sweeps.size(), 5U);
  for (const MapSweep& sweep : sweeps) {
    const auto n = static_cast<double>(sweep.readings.size());
    EXPECT_DOUBLE_EQ(sweep.weight, n > 4 ? 4 / n : 1.0);
  }
  FingerprintSettings two;
  two.n_eff = 2;
  EXPECT_LT(CollectMapSweeps(synthetic.site, map, evidence, two)[0].weight, sweeps[0].weight);
}

TEST(CollectMapSweeps, CutsALongScanAndSharesItsSilence) {
  SyntheticSite synthetic(1);
  Evidence evidence;
  evidence.transmitters = synthetic.site.transmitters;
  evidence.transmitters.push_back({Radio::kWifi, "a stranger"});
  const double heard_s[] = {0.0, 0.4, 1.1, 2.5, 3.0};
  for (std::uint32_t i = 0; i < 5; ++i) {
    evidence.readings.push_back({SyntheticSite::At(heard_s[i]), SyntheticSite::At(3.5), i, -60.0F});
  }
  evidence.readings.push_back({SyntheticSite::At(3.2), SyntheticSite::At(3.5), 12, -50.0F});
  const auto sweeps = CollectMapSweeps(synthetic.site, synthetic.site.maps.front(), evidence,
                                       FingerprintSettings(), 1.0);
  ASSERT_EQ(sweeps.size(), 3U);
  EXPECT_EQ(sweeps[0].readings.size(), 2U);
  EXPECT_EQ(sweeps[1].readings.size(), 1U);
  EXPECT_EQ(sweeps[2].readings.size(), 2U);
  EXPECT_DOUBLE_EQ(sweeps[0].silence_share, 0.4);
  EXPECT_EQ(sweeps[0].mean_heard_ns, SyntheticSite::At(0.2));
  EXPECT_EQ(sweeps[2].mean_heard_ns, SyntheticSite::At(2.75));
  for (const MapSweep& sweep : sweeps) EXPECT_DOUBLE_EQ(sweep.weight, 4.0 / 5.0);
}

// A reading of 3/4 of the variance's inverse, sqrt(0.75) * 1.5 sigmas off.
TEST(LikelihoodGrid, DividesTheVarianceByAReadingsPrecision) {
  RadioMap map;
  map.grid = {{0, 0}, 1.0, 4, 4};
  map.sigma_min_db = 4;
  map.hear_weight = 0;
  map.fields.push_back({0, 0, 0, 0, 0, -60, std::log(4.0F), 0, {}, {}, {}});
  map.silence_nats.assign(16, 0.0F);
  MapSweep sweep;
  sweep.readings.push_back({0, -66.0F, 0, 0.75F});
  const std::vector<Eigen::Vector2d> positions{{1.3, 1.6}};
  const auto nats = LikelihoodGrid(map, positions, {}).Evaluate(std::vector{sweep});
  EXPECT_NEAR(nats[0][0], 0.5 * 0.75 * 1.5 * 1.5, 1e-5);
  // An offset of 3 dB integrated out: a normal of the summed variances.
  const auto offset = LikelihoodGrid(map, positions, {0, 3.0}).Evaluate(std::vector{sweep});
  const double variance = 16 / 0.75 + 9;
  EXPECT_NEAR(offset[0][0], 0.5 * 36 / variance + 0.5 * std::log(variance / (16 / 0.75)), 1e-5);
}

// eta(-75) = 43.49 and at most 84.65 percent (TCPF).
TEST(CollectMapSweeps, WeakReadingsOfAWalkerAreLessPrecise) {
  SyntheticSite synthetic(1);
  Evidence evidence;
  evidence.transmitters = synthetic.site.transmitters;
  evidence.readings.push_back({SyntheticSite::At(1), SyntheticSite::At(2), 0, -75.0F});
  evidence.readings.push_back({SyntheticSite::At(11), SyntheticSite::At(12), 0, -75.0F});
  evidence.motion = {{SyntheticSite::At(0), SyntheticSite::At(10), MotionState::kWalking},
                     {SyntheticSite::At(10), SyntheticSite::At(20), MotionState::kStanding}};
  FingerprintSettings settings;
  const RadioMap& map = synthetic.site.maps.front();
  EXPECT_EQ(CollectMapSweeps(synthetic.site, map, evidence, settings)[0].readings[0].precision, 1);
  settings.refresh_rate = true;
  const auto sweeps = CollectMapSweeps(synthetic.site, map, evidence, settings);
  ASSERT_EQ(sweeps.size(), 2U);
  EXPECT_NEAR(sweeps[0].readings[0].precision, 43.49 / 84.65, 1e-3);
  EXPECT_EQ(sweeps[1].readings[0].precision, 1);
}

// One access point heard, one silent, both the same everywhere: the closed form of the model.
TEST(LikelihoodGrid, IsTheFullNegativeLogLikelihood) {
  RadioMap map;
  map.grid = {{0, 0}, 1.0, 4, 4};
  map.sigma_min_db = 2;
  const double p_heard = 0.8, p_silent = 0.3;
  const auto logit = [](double p) { return static_cast<float>(std::log(p / (1 - p))); };
  map.fields.push_back({0, 0, 0, 0, 0, -60, std::log(4.0F), logit(p_heard), {}, {}, {}});
  map.fields.push_back({1, 0, 0, 0, 0, -70, std::log(3.0F), logit(p_silent), {}, {}, {}});
  map.silence_nats.assign(16, static_cast<float>(-std::log(1 - p_heard) - std::log(1 - p_silent)));
  MapSweep sweep;
  sweep.readings.push_back({0, -66.0F, 0});
  const std::vector<Eigen::Vector2d> positions{{1.3, 1.6}, {400, -3}};
  const auto nats = LikelihoodGrid(map, positions, {}).Evaluate(std::vector{sweep});
  const double expected =
      0.5 * 1.5 * 1.5 + std::log(4.0 / 2.0) - std::log(p_heard) - std::log(1 - p_silent);
  EXPECT_NEAR(nats[0][0], expected, 1e-5);
  EXPECT_NEAR(nats[0][1], expected, 1e-5);
}

// Far beyond the loss's scale a reading costs a straight line, as in the graph's factor.
TEST(LikelihoodGrid, BoundsTheSlopeOfAReadingUnderALoss) {
  RadioMap map;
  map.grid = {{0, 0}, 1.0, 4, 4};
  map.sigma_min_db = 4;
  map.hear_weight = 0;
  map.fields.push_back({0, 0, 0, 0, 0, -60, std::log(4.0F), 0, {}, {}, {}});
  map.silence_nats.assign(16, 0.0F);
  const std::vector<Eigen::Vector2d> positions{{1.5, 1.5}};
  const LossSettings huber{LossKind::kHuber, 1.5};
  const auto cost = [&](float rssi_dbm) {
    MapSweep sweep;
    sweep.readings.push_back({0, rssi_dbm, 0});
    return LikelihoodGrid(map, positions, {}, huber).Evaluate(std::vector{sweep})[0][0];
  };
  EXPECT_NEAR(cost(-64), 0.5, 1e-6);
  EXPECT_NEAR(cost(-80), 1.5 * 5 - 0.5 * 1.5 * 1.5, 1e-5);
  EXPECT_NEAR(cost(-84) - cost(-80), 1.5, 1e-5);
}

TEST(LikelihoodGrid, IntegratesACommonOffsetOut) {
  RadioMap map;
  map.grid = {{0, 0}, 1.0, 4, 4};
  map.sigma_min_db = 1;
  map.hear_weight = 0;
  map.fields.push_back({0, 0, 0, 0, 0, -60, std::log(4.0F), 0, {}, {}, {}});
  map.fields.push_back({1, 0, 0, 0, 0, -70, std::log(3.0F), 0, {}, {}, {}});
  map.silence_nats.assign(16, 5.0F);
  MapSweep sweep;
  sweep.readings.push_back({0, -68.0F, 0});
  sweep.readings.push_back({1, -75.0F, 0});
  const std::vector<Eigen::Vector2d> positions{{1.5, 1.5}};
  const double mean_db = 1.5, sigma_db = 3.0;
  const auto nats =
      LikelihoodGrid(map, positions, {mean_db, sigma_db}).Evaluate(std::vector{sweep});
  // The same integral by the midpoint rule.
  double integral = 0;
  const double step = 0.01;
  for (double offset = -40; offset < 40; offset += step) {
    const double z0 = (-8 + offset) / 4, z1 = (-5 + offset) / 3, z = (offset - mean_db) / sigma_db;
    integral += std::exp(-0.5 * (z0 * z0 + z1 * z1 + z * z)) / (4.0 * 3.0 * sigma_db) * step;
  }
  const double expected = -std::log(integral / std::sqrt(2 * std::numbers::pi));
  EXPECT_NEAR(nats[0][0], expected, 1e-4);
}

TEST(LikelihoodGrid, AgreesWithTheMapReadPointByPoint) {
  SyntheticSite synthetic(3);
  const Evidence evidence = synthetic.Walk({{5, 5}, {40, 30}}, 0.1, 4);
  RadioMap map = synthetic.site.maps.front();
  map.body_shadow_db = 2;
  auto sweeps = CollectMapSweeps(synthetic.site, map, evidence, FingerprintSettings());
  // Some know which way the walker faced.
  for (std::size_t s = 0; s < sweeps.size(); s += 2) {
    sweeps[s].facing = Eigen::Rotation2Dd(static_cast<double>(s)) * Eigen::Vector2d::UnitX();
  }
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-20, 60);
  std::vector<Eigen::Vector2d> positions(300);
  for (Eigen::Vector2d& position : positions) {
    position.x() = coordinate(random);
    position.y() = coordinate(random);
  }
  const auto nats = LikelihoodGrid(map, positions, {}).Evaluate(sweeps);
  for (std::size_t s = 0; s < sweeps.size(); ++s) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const FieldBasis basis = EvaluateBasis(map.grid, positions[i]);
      double expected = map.Silence(basis).value;
      for (const MapSweep::Reading& reading : sweeps[s].readings) {
        const FieldValue value = map.Evaluate(reading.field, basis);
        const double shadow_db =
            map.body_shadow_db *
            sweeps[s].facing.dot(
                BearingOf(map.fields[reading.field].source_m.cast<double>(), positions[i]).value);
        const double r =
            (reading.rssi_dbm - value.mean_dbm - shadow_db) / std::exp(value.log_sigma);
        expected += 0.5 * r * r + value.log_sigma - std::log(map.sigma_min_db) - value.logit_hear;
      }
      EXPECT_NEAR(nats[s][i], sweeps[s].weight * expected, 2e-3) << positions[i].transpose();
    }
  }
}

// What a thread remembers must never be another map's, another scan's or another loss's.
TEST(EvaluateSweeps, IsTheGridsAnswerHoweverOftenAndInWhateverOrder) {
  SyntheticSite one(1), other(2);
  const Evidence evidence = one.Walk({{10, 10}, {30, 10}}, 0.1, 4);
  const auto sweeps =
      CollectMapSweeps(one.site, one.site.maps.front(), evidence, FingerprintSettings());
  auto louder = sweeps;
  louder[2].readings[0].rssi_dbm += 1;
  auto facing = sweeps;
  facing[1].facing = {0, 1};
  auto backwards_twice = sweeps;
  backwards_twice.insert(backwards_twice.end(), sweeps.rbegin(), sweeps.rend());
  const std::vector<Eigen::Vector2d> positions = {{5, 5}, {20, 12}, {33, 8}};
  const std::vector<Eigen::Vector2d> moved = {{5, 5}, {20, 12}, {33, 9}};
  const LossSettings none, huber = {LossKind::kHuber, 1.345};
  RadioMap altered = one.site.maps.front();
  altered.fields[0].log_sigma[7] += 0.5F;
  RadioMap shaded = one.site.maps.front();
  shaded.body_shadow_db = 3;
  const std::vector<const RadioMap*> maps = {&one.site.maps.front(), &other.site.maps.front(),
                                             &altered, &shaded};
  for (int round = 0; round < 2; ++round) {
    for (const RadioMap* map : maps) {
      for (const auto& scans : {sweeps, louder, facing, backwards_twice}) {
        for (const auto& places : {positions, moved}) {
          for (const LossSettings& loss : {none, huber}) {
            for (const RssiOffsetPrior& offset : {RssiOffsetPrior{0, 3}, RssiOffsetPrior{2, 3}}) {
              const auto costs = EvaluateSweeps(*map, places, offset, loss, scans);
              const auto expected = LikelihoodGrid(*map, places, offset, loss).Evaluate(scans);
              ASSERT_EQ(costs.size(), expected.size());
              for (std::size_t s = 0; s < costs.size(); ++s) EXPECT_EQ(*costs[s], expected[s]);
            }
          }
        }
      }
    }
  }
  const auto first = EvaluateSweeps(one.site.maps.front(), positions, {0, 3.0}, none, sweeps);
  EXPECT_EQ(first, EvaluateSweeps(one.site.maps.front(), positions, {0, 3.0}, none, sweeps));
}

}  // namespace
}  // namespace walkgraph
