#include "frontends/radio_map/magnetic_trainer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "frontends/radio_map/magnetic_map.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {
namespace {

// The field of a hall of 40 x 12 m: waves of 8 m.
Eigen::Vector2d TrueField(const Eigen::Vector2d& at) {
  return {30 + 8 * std::sin(at.x() * 2 * std::numbers::pi / 8),
          -35 + 6 * std::cos(at.y() * 2 * std::numbers::pi / 8)};
}

// What a walk measures beside the field, sample by sample.
using Noise = std::function<Eigen::Vector2d(std::mt19937*)>;

// Walks to and fro along the hall, a sample every 0.5 m.
Site Survey(int walks, const Noise& noise, std::uint32_t seed = 3) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> lane(0, 12);
  Site site;
  for (int walk = 0; walk < walks; ++walk) {
    const double y = lane(random);
    for (double x = 0; x <= 40; x += 0.5) {
      const Eigen::Vector2d field = TrueField({x, y}) + noise(&random);
      SurveyMagnetic sample;
      sample.position_m = Eigen::Vector2d(x, y).cast<float>();
      sample.walk = sample.trial = static_cast<std::uint32_t>(walk);
      sample.norm_ut = static_cast<float>(field.norm());
      sample.inclination_rad = static_cast<float>(std::atan2(field.y(), field.x()));
      site.magnetic.push_back(sample);
    }
  }
  return site;
}

Noise White(double sigma_ut) {
  return [sigma_ut](std::mt19937* random) -> Eigen::Vector2d {
    std::normal_distribution<double> normal(0, sigma_ut);
    const double horizontal = normal(*random), down = normal(*random);
    return {horizontal, down};
  };
}

TEST(MagneticTrainer, MapIsTheFieldWithinItsSpread) {
  const Site site = Survey(80, White(1.0));
  const std::vector<MagneticMap> maps = TrainMagneticMaps(site);
  ASSERT_EQ(maps.size(), 1U);
  double squares = 0, whitened = 0;
  int count = 0;
  for (double x = 4; x <= 36; x += 0.7) {
    for (double y = 2; y <= 10; y += 0.7) {
      const FieldBasis basis = EvaluateBasis(maps[0].grid, {x, y});
      for (int c = 0; c < 2; ++c) {
        const double error = maps[0].Mean(c, basis).value - TrueField({x, y})[c];
        squares += error * error;
        whitened += (error * error + 1.0) / std::exp(2 * maps[0].LogSigma(c, basis).value);
        ++count;
      }
    }
  }
  EXPECT_LT(std::sqrt(squares / count), 1.5);  // of a field that varies by 5
  // A new sample of 1 microtesla of noise.
  EXPECT_NEAR(std::sqrt(whitened / count), 1.0, 0.25);
}

TEST(MagneticTrainer, FarFromTheSurveyItIsTheFloorAsAWhole) {
  Site site = Survey(30, White(1.0));
  // A second lane, so far away that the grid reaches over what nobody surveyed.
  Site other = Survey(3, White(1.0));
  for (SurveyMagnetic& sample : other.magnetic) {
    sample.position_m.y() += 100;
    sample.walk = sample.trial += 100;
    site.magnetic.push_back(sample);
  }
  const std::vector<MagneticMap> maps = TrainMagneticMaps(site);
  ASSERT_EQ(maps.size(), 1U);
  const FieldBasis between = EvaluateBasis(maps[0].grid, {20, 60});
  const FieldBasis within = EvaluateBasis(maps[0].grid, {20, 6});
  // The sine's standard deviation over the hall is 8 / sqrt(2).
  EXPECT_NEAR(maps[0].Mean(0, between).value, 30, 1);
  EXPECT_NEAR(std::exp(maps[0].LogSigma(0, between).value), 8 / std::sqrt(2), 2);
  EXPECT_LT(maps[0].LogSigma(0, within).value, maps[0].LogSigma(0, between).value - 0.5);
}

// Walks surveyed beside where they were: the map's error is about as large, and is not taken for
// noise that many samples would average out.
TEST(MagneticTrainer, MapErrorIsThatOfTheSurvey) {
  const std::vector<MagneticMap> exact = TrainMagneticMaps(Survey(80, White(1.0)));
  std::mt19937 random(5);
  Site shifted = Survey(80, White(1.0));
  std::normal_distribution<float> normal(0, 1);
  Eigen::Vector2f shift_m = Eigen::Vector2f::Zero();
  for (std::size_t i = 0; i < shifted.magnetic.size(); ++i) {
    if (i == 0 || shifted.magnetic[i].walk != shifted.magnetic[i - 1].walk) {
      const float x = normal(random), y = normal(random);
      shift_m = {x, y};
    }
    shifted.magnetic[i].position_m += shift_m;
  }
  const std::vector<MagneticMap> beside = TrainMagneticMaps(shifted);
  ASSERT_EQ(exact.size(), 1U);
  ASSERT_EQ(beside.size(), 1U);
  EXPECT_LT(exact[0].map_error_sigma_m, 0.5);
  EXPECT_GE(beside[0].map_error_sigma_m, 0.7);
  EXPECT_LE(beside[0].map_error_sigma_m, 1.4);
}

TEST(MagneticTrainer, NeedsSixTrials) {
  EXPECT_TRUE(TrainMagneticMaps(Survey(5, White(1.0))).empty());
  EXPECT_TRUE(TrainMagneticMaps(Site()).empty());
  Site site = Survey(12, White(1.0));
  for (SurveyMagnetic& sample : site.magnetic) sample.trial = sample.walk % 5;
  EXPECT_TRUE(TrainMagneticMaps(site).empty());
}

}  // namespace
}  // namespace walkgraph
