#include "frontends/radio_map/shift_posterior.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "frontends/radio_world.h"

namespace walkgraph {
namespace {

// The middle in cells of 0.2 m: what follows holds on cells of any size.
const ShiftGrid& Shifts() {
  static const ShiftGrid shifts(1.0, 12, 2, 5);
  return shifts;
}

// What a scan says whose likelihood has a standard deviation of 2 m about `peak`.
Eigen::ArrayXd NatsAbout(const Eigen::Vector2d& peak, const ShiftGrid& shifts = Shifts()) {
  Eigen::ArrayXd nats(static_cast<Eigen::Index>(shifts.size()));
  for (Eigen::Index i = 0; i < nats.size(); ++i) {
    nats[i] = (shifts.At(static_cast<std::size_t>(i)) - peak).squaredNorm() / 8.0;
  }
  return nats;
}

TEST(ShiftPosterior, ANormalPieceHasTheDensityOfTheConvolution) {
  const double sigma_m = 3.0;
  const Eigen::Vector2d peak(2, -1);
  const double variance = 2.0 * 2.0 + sigma_m * sigma_m;
  const double density = std::exp(-0.5 * peak.squaredNorm() / variance) / (2.0 * M_PI * variance);
  // Twice: as a whole and as its only part. The chance of being lost takes 2 %.
  const double area_m2 = 25 * 25;
  const double expected = 2.0 * std::log(0.98 * density + 0.02 / area_m2);
  const auto score = [&](const ShiftGrid& shifts) {
    const PiecePosterior piece(shifts, {NatsAbout(peak, shifts)});
    return piece.Score(SharedErrorKernel(shifts, sigma_m));
  };
  EXPECT_NEAR(score(ShiftGrid(1.0, 12)), expected, 1e-3);
  // Where cells change their size the midpoint rule is good to 3e-3 nats.
  EXPECT_NEAR(score(Shifts()), expected, 5e-3);
}

TEST(ShiftPosterior, AGridWithAFineMiddleCoversTheSameArea) {
  const ShiftGrid coarse(2.5, 8), fine(2.5, 8, 1, 5);
  EXPECT_EQ(coarse.size(), 17U * 17U);
  EXPECT_EQ(fine.size(), 17U * 17U - 9U + 9U * 25U);
  EXPECT_NEAR(fine.area_m2().sum(), coarse.area_m2().sum(), 1e-9);
  EXPECT_NEAR(coarse.area_m2().sum(), std::pow(17 * 2.5, 2), 1e-9);
}

// Pieces whose error is drawn with 4 m are placed best by a kernel of 4 m.
TEST(ShiftPosterior, TheErrorThatPiecesHaveScoresBest) {
  std::mt19937 random(5);
  std::normal_distribution<double> error(0.0, 4.0), noise(0.0, 2.0);
  SharedErrorKernels kernels(Shifts());
  const std::array sigmas_m{1.0, 2.0, 4.0, 8.0};
  std::array<double, 4> scores{};
  for (int piece = 0; piece < 200; ++piece) {
    const Eigen::Vector2d shared(error(random), error(random));
    std::vector<Eigen::ArrayXd> parts;
    for (int part = 0; part < 4; ++part) {
      parts.push_back(NatsAbout(shared + Eigen::Vector2d(noise(random), noise(random))));
    }
    const PiecePosterior posterior(Shifts(), parts);
    for (std::size_t i = 0; i < sigmas_m.size(); ++i) {
      scores[i] += posterior.Score(kernels.At(sigmas_m[i]));
    }
  }
  for (const std::size_t other : {0, 1, 3}) EXPECT_GT(scores[2], scores[other] + 10) << other;
}

// Off the survey the map's distance is the distance, as far as a spline over points 4 m apart has
// it; on the survey it is small.
TEST(SurveyDistance, IsThatToTheNearestScan) {
  RadioWorld world(3);
  const std::vector<SurveyWalk> walks = {world.Walk({5, 2}, {55, 2})};
  const Site site = TrainSite(world.building, walks, {});
  ASSERT_EQ(site.maps.size(), 1u);
  const RadioMap& map = site.maps[0];
  for (const double y : {8.0, 14.0, 22.0}) {
    const ScalarValue distance = map.SurveyDistance(EvaluateBasis(map.grid, {30, y}));
    EXPECT_NEAR(distance.value, y - 2, 0.6) << y;
    EXPECT_NEAR(distance.gradient.y(), 1.0, 0.1) << y;
  }
  EXPECT_LT(map.SurveyDistance(EvaluateBasis(map.grid, {30, 2})).value, 2.5);
}

}  // namespace
}  // namespace walkgraph
