#include "frontends/radio_map/device_offsets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "frontends/radio_map/trainer.h"
#include "frontends/radio_world.h"

namespace walkgraph {
namespace {

constexpr double kSquareM = 3;

SurveyScan Scan(std::uint32_t walk, std::uint32_t transmitter, double x_m, double rssi_dbm,
                Radio radio = Radio::kWifi) {
  SurveyScan scan;
  scan.walk = scan.trial = walk;
  scan.radio = radio;
  scan.readings = {{transmitter, static_cast<float>(rssi_dbm), 0, {static_cast<float>(x_m), 0.0F}}};
  return scan;
}

// Every walk once in each of the same squares, hearing one transmitter.
std::vector<SurveyScan> Balanced(const std::vector<double>& offsets_db, int squares,
                                 double noise_db, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<SurveyScan> scans;
  for (std::uint32_t walk = 0; walk < offsets_db.size(); ++walk) {
    for (int c = 0; c < squares; ++c) {
      const double level_dbm = -60 - 7.0 * (c % 4);
      scans.push_back(
          Scan(walk, 0, kSquareM * c, level_dbm + offsets_db[walk] + noise_db * normal(random)));
    }
  }
  return scans;
}

// In a balanced design the restricted likelihood has the mean squares of the analysis of variance
// as its solution, and the predictions are the walks' mean deviations, shrunk.
TEST(DeviceOffsetsTest, ABalancedSurveyGivesTheAnalysisOfVariance) {
  const std::vector<double> truth{3, -4, 1, 0, 2, -1, 5, -6};
  constexpr int kSquares = 12;
  const std::vector<SurveyScan> scans = Balanced(truth, kSquares, 2, 3);
  const auto walks = static_cast<int>(truth.size());
  const auto at = [&](int walk, int square) {
    return double{scans[static_cast<std::size_t>(walk * kSquares + square)].readings[0].rssi_dbm};
  };
  std::vector<double> walk_mean(truth.size()), square_mean(kSquares);
  double mean = 0;
  for (int w = 0; w < walks; ++w) {
    for (int c = 0; c < kSquares; ++c) {
      walk_mean[static_cast<std::size_t>(w)] += at(w, c) / kSquares;
      square_mean[static_cast<std::size_t>(c)] += at(w, c) / walks;
      mean += at(w, c) / walks / kSquares;
    }
  }
  double between = 0, within = 0;
  for (int w = 0; w < walks; ++w) {
    between += kSquares * std::pow(walk_mean[static_cast<std::size_t>(w)] - mean, 2) / (walks - 1);
    for (int c = 0; c < kSquares; ++c) {
      within += std::pow(at(w, c) - walk_mean[static_cast<std::size_t>(w)] -
                             square_mean[static_cast<std::size_t>(c)] + mean,
                         2) /
                ((walks - 1) * (kSquares - 1));
    }
  }
  const DeviceOffsets offsets = EstimateDeviceOffsets(scans, Radio::kWifi, kSquareM);
  // The ratio of variances is sought in steps of 5 %.
  EXPECT_NEAR(offsets.spread_db, std::sqrt((between - within) / kSquares),
              0.03 * offsets.spread_db);
  EXPECT_NEAR(offsets.reading_sigma_db, std::sqrt(within), 0.01 * std::sqrt(within));
  for (std::size_t w = 0; w < truth.size(); ++w) {
    EXPECT_NEAR(offsets.offset_db[w], (1 - within / between) * (walk_mean[w] - mean), 0.01);
  }
}

TEST(DeviceOffsetsTest, OnePhoneHasHardlyAnySpread) {
  double mean_spread_db = 0;
  constexpr int kSurveys = 20;
  for (std::uint32_t seed = 0; seed < kSurveys; ++seed) {
    mean_spread_db += EstimateDeviceOffsets(Balanced(std::vector<double>(10, 0.0), 20, 4, seed),
                                            Radio::kWifi, kSquareM)
                          .spread_db /
                      kSurveys;
  }
  // A walk's mean of 20 readings is known to 0.9 dB.
  EXPECT_LT(mean_spread_db, 0.6);
}

TEST(DeviceOffsetsTest, HowLoudATransmitterIsInItsSquareDoesNotMatter) {
  std::vector<SurveyScan> scans = Balanced({4, -2, 0, -2}, 9, 1, 5);
  const DeviceOffsets before = EstimateDeviceOffsets(scans, Radio::kWifi, kSquareM);
  for (SurveyScan& scan : scans) {
    if (scan.readings[0].position_m.x() > 10) scan.readings[0].rssi_dbm -= 16;
  }
  const DeviceOffsets after = EstimateDeviceOffsets(scans, Radio::kWifi, kSquareM);
  for (std::size_t w = 0; w < 4; ++w) {
    EXPECT_NEAR(after.offset_db[w], before.offset_db[w], 1e-5);
  }
}

TEST(DeviceOffsetsTest, WhoMeetsNobodyAndOtherRadiosStayOut) {
  std::vector<SurveyScan> scans = Balanced({4, -4, 3, -3}, 9, 1, 5);
  scans.push_back(Scan(4, 0, 500, -30));                // where nobody else was
  scans.push_back(Scan(5, 99, 0, -30));                 // a transmitter of its own
  scans.push_back(Scan(0, 0, 0, -10, Radio::kBeacon));  // alone on its radio
  const DeviceOffsets offsets = EstimateDeviceOffsets(scans, Radio::kWifi, kSquareM);
  ASSERT_EQ(offsets.offset_db.size(), 6u);
  EXPECT_NEAR(offsets.offset_db[4], 0, 1e-12);
  EXPECT_NEAR(offsets.offset_db[5], 0, 1e-12);
  EXPECT_NEAR(offsets.offset_db[0], 4, 0.7);
  for (const double offset_db : EstimateDeviceOffsets(scans, Radio::kBeacon, kSquareM).offset_db) {
    EXPECT_EQ(offset_db, 0);
  }
  EXPECT_TRUE(EstimateDeviceOffsets({}, Radio::kWifi, kSquareM).offset_db.empty());
}

// More walks than the variances are taken from: the others' offsets are found all the same.
TEST(DeviceOffsetsTest, ThousandsOfWalksAreLevelledToo) {
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  std::vector<double> truth(2500);
  for (double& offset_db : truth) offset_db = 4 * normal(random);
  const DeviceOffsets offsets =
      EstimateDeviceOffsets(Balanced(truth, 16, 2, 9), Radio::kWifi, kSquareM);
  EXPECT_NEAR(offsets.spread_db, 4, 0.3);
  EXPECT_NEAR(offsets.reading_sigma_db, 2, 0.05);
  double square_error = 0;
  for (std::size_t w = 0; w < truth.size(); ++w) {
    square_error +=
        std::pow(offsets.offset_db[w] - truth[w], 2) / static_cast<double>(truth.size());
  }
  // A mean of 16 readings is known to half a decibel.
  EXPECT_LT(std::sqrt(square_error), 0.55);
}

// Mean error of the fields at places that the survey knows, and their mean sigma, dB.
struct FieldQuality {
  double error_db = 0, sigma_db = 0;
};

FieldQuality QualityOf(const RadioWorld& world, const Site& site) {
  FieldQuality quality;
  int count = 0;
  const RadioMap& map = site.maps.front();
  for (double x = 3; x < RadioWorld::kWidthM; x += 4) {
    const Eigen::Vector2d at(x, 12);
    const FieldBasis basis = EvaluateBasis(map.grid, at);
    for (std::size_t f = 0; f < map.fields.size(); ++f) {
      const double mean_dbm = world.MeanDbm(map.fields[f].transmitter, at);
      if (RadioWorld::HearProbability(mean_dbm) < 0.9) continue;
      const FieldValue value = map.EvaluateValue(static_cast<int>(f), basis);
      quality.error_db += std::abs(value.mean_dbm - mean_dbm);
      quality.sigma_db += std::exp(value.log_sigma);
      ++count;
    }
  }
  quality.error_db /= count;
  quality.sigma_db /= count;
  return quality;
}

TEST(DeviceOffsetsTest, FieldsOfASurveyWithManyPhonesAreThoseOfOne) {
  RadioWorld world(1);
  std::vector<SurveyWalk> walks = world.Survey(3.0);
  const std::size_t first_phone = walks.size();
  for (SurveyWalk& walk : world.Survey(3.0)) walks.push_back(walk);
  const FieldQuality one_phone = QualityOf(world, TrainSite(world.building, walks, {}));
  std::vector<Evidence> evidence;
  evidence.reserve(walks.size());
  for (std::size_t i = 0; i < walks.size(); ++i) {
    evidence.push_back(*walks[i].evidence);
    for (RadioReading& reading : evidence.back().readings) {
      reading.rssi_dbm += i < first_phone ? 6.0F : -6.0F;
    }
    walks[i].evidence = &evidence.back();
  }
  const Site levelled = TrainSite(world.building, walks, {});
  const FieldQuality as_one = QualityOf(world, levelled);
  TrainerSettings raw;
  raw.level_devices = false;
  const FieldQuality mixed = QualityOf(world, TrainSite(world.building, walks, raw));
  EXPECT_LT(as_one.error_db, 1.2 * one_phone.error_db + 0.3);
  EXPECT_LT(as_one.sigma_db, 1.15 * one_phone.sigma_db);
  EXPECT_GT(mixed.sigma_db, 1.3 * one_phone.sigma_db);
  for (const SurveyScan& scan : levelled.scans) {
    EXPECT_NEAR(scan.device_offset_db, scan.walk < first_phone ? 6 : -6, 1.5) << scan.walk;
  }
}

SurveyScan ScanWithOffset(std::uint32_t walk, float offset_db) {
  SurveyScan scan = Scan(walk, 0, 0, -60);
  scan.device_offset_db = offset_db;
  return scan;
}

TEST(DeviceLoudnessTest, IsTheMeanOfAModelsWalksAndTheSpreadOfOneMore) {
  std::vector<SurveyScan> scans;
  const std::vector<float> offsets_db{3, -3, 5, -5, -4};
  for (std::uint32_t walk = 0; walk < 5; ++walk) {
    scans.push_back(ScanWithOffset(walk, offsets_db[walk]));
    scans.push_back(ScanWithOffset(walk, offsets_db[walk]));  // scans do not count, walks do
  }
  const auto summary = SummariseDevices(scans, {"loud", "dull", "loud", "dull", "dull"});
  ASSERT_EQ(summary.size(), 2U);
  EXPECT_EQ(summary[0].device, "dull");
  EXPECT_NEAR(summary[0].mean_db, -4, 1e-9);
  EXPECT_EQ(summary[1].device, "loud");
  EXPECT_NEAR(summary[1].mean_db, 4, 1e-9);
  // Squares about the means: 1 + 1 + 0 + 1 + 1, of five walks of two models.
  EXPECT_NEAR(summary[0].sigma_db, std::sqrt(4.0 / 3 * (1 + 1.0 / 3)), 1e-9);
  EXPECT_NEAR(summary[1].sigma_db, std::sqrt(4.0 / 3 * (1 + 1.0 / 2)), 1e-9);
}

TEST(DeviceLoudnessTest, SaysNothingWhereWalksDoNotTell) {
  EXPECT_TRUE(SummariseDevices({}, {}).empty());
  const std::vector<SurveyScan> alike{ScanWithOffset(0, 0), ScanWithOffset(1, 0),
                                      ScanWithOffset(2, 0), ScanWithOffset(3, 0)};
  EXPECT_TRUE(SummariseDevices(alike, {"a", "a", "a", "a"}).empty());
  const std::vector<SurveyScan> few{ScanWithOffset(0, 2), ScanWithOffset(1, -2),
                                    ScanWithOffset(2, 1), ScanWithOffset(3, 0)};
  EXPECT_TRUE(SummariseDevices(few, {"a", "a", "b", "b"}).empty());
  EXPECT_EQ(SummariseDevices(few, {"a", "a", "a", "a"}).size(), 1U);
}

}  // namespace
}  // namespace walkgraph
