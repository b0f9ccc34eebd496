#include "solvers/baselines/discrete_smoother.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "solvers/baselines/discrete_motion.h"
#include "solvers/baselines/lattice.h"

namespace walkgraph {
namespace {

// Everything that can be taken on 3 x 3 cells in three epochs, with every cost worked out again.
class BruteForceTest : public ::testing::Test {
 protected:
  BruteForceTest() : random_(21) {
    site_.building.floors.resize(1);
    site_.path = {{{0, 0}, 0, 0}};
    settings_.spacing_m = 1.5;
    settings_.reach_m = 2.2;
    settings_.beam_nats = 1e6;
    settings_.heading_bin_rad = 1e-9;  // no width of a bin in the transition
    factors_.heading_offset.mode = StateMode::kFixed;
    factors_.absolute_heading.sigma_rad = 1e-9;
    factors_.step_scale.prior_sigma = 0;
    factors_.standing.sigma_mps = 0.7;
    evidence_.floor = 0;
    evidence_.begin_ns = 0;
    evidence_.end_ns = 8 * kNsPerSecond;
    evidence_.absolute_heading_rad.push_back(0, 0.6);
    evidence_.absolute_heading_sigma_rad.push_back(0.1);
    evidence_.steps = {{kNsPerSecond, 2 * kNsPerSecond, 0.9},
                       {5 * kNsPerSecond, 6 * kNsPerSecond, 0.8},
                       {6 * kNsPerSecond, 7 * kNsPerSecond, 0.8}};
    std::uniform_real_distribution<double> place(-3, 3);
    for (int i = 0; i < 9; ++i) {
      const double x = place(random_), y = place(random_);
      evidence_.anchors.push_back({(i / 3) * 4 * kNsPerSecond, {x, y}, 0, 1.0 + 0.2 * i});
    }
  }

  double Emission(int epoch, const Eigen::Vector2d& at) const {
    double nats = 0;
    for (const PositionAnchor& anchor : evidence_.anchors) {
      if (anchor.time_ns != epoch * 4 * kNsPerSecond) continue;
      const double variance = anchor.sigma_m * anchor.sigma_m + 1.5 * 1.5 / 12;
      nats += 0.5 * (at - anchor.position_m).squaredNorm() / variance;
    }
    return nats;
  }

  double Transition(int steps, double walked_m, const Eigen::Vector2d& moved) const {
    const StepSettings& step = factors_.step;
    const double noise = std::pow(step.sigma_along_m, 2) + std::pow(step.sigma_across_m, 2);
    const double variance = 0.7 * 0.7 * 4 + 0.5 * steps * noise + 1.5 * 1.5 / 6;
    const Eigen::Vector2d expected = walked_m * Eigen::Vector2d(std::cos(0.6), std::sin(0.6));
    return 0.5 * (moved - expected).squaredNorm() / variance +
           std::log(2 * std::numbers::pi * variance);
  }

  Site site_;
  Evidence evidence_;
  FactorSettings factors_;
  DiscreteSettings settings_;
  std::mt19937 random_;
};

TEST_F(BruteForceTest, BestPathIsTheBestOfAll) {
  const Lattice lattice(site_, {0}, settings_.spacing_m, settings_.reach_m);
  ASSERT_GE(lattice.size(), 8U);
  const std::vector<Eigen::Vector2d>& cells = lattice.centers_m();
  double best = std::numeric_limits<double>::infinity();
  std::vector<Eigen::Vector2d> best_path;
  for (const Eigen::Vector2d& a : cells) {
    for (const Eigen::Vector2d& b : cells) {
      for (const Eigen::Vector2d& c : cells) {
        const double nats = Emission(0, a) + Emission(1, b) + Emission(2, c) +
                            Transition(1, 0.9, b - a) + Transition(2, 1.6, c - b);
        if (nats >= best) continue;
        best = nats;
        best_path = {a, b, c};
      }
    }
  }
  const DeadReckonedPath walk = DeadReckon(site_, evidence_, factors_);
  const std::vector<DiscretePath> paths =
      SmoothOnLattice(site_, evidence_, walk, factors_, settings_, 0);
  ASSERT_FALSE(paths.empty());
  EXPECT_NEAR(paths[0].negative_log_posterior, best, 1e-3);
  ASSERT_EQ(paths[0].position_m.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LT((paths[0].position_m.value[k] - best_path[k]).norm(), 1e-9);
  }
}

TEST_F(BruteForceTest, PathsAreDistinctAndBestFirst) {
  settings_.paths = 5;
  settings_.distinct_m = 0.8;
  const DeadReckonedPath walk = DeadReckon(site_, evidence_, factors_);
  const std::vector<DiscretePath> paths =
      SmoothOnLattice(site_, evidence_, walk, factors_, settings_, 0);
  ASSERT_GT(paths.size(), 1U);
  EXPECT_LE(paths.size(), 5U);
  for (std::size_t i = 1; i < paths.size(); ++i) {
    EXPECT_GE(paths[i].negative_log_posterior, paths[i - 1].negative_log_posterior);
    for (std::size_t j = 0; j < i; ++j) {
      double apart = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        apart += (paths[i].position_m.value[k] - paths[j].position_m.value[k]).norm() / 3;
      }
      EXPECT_GE(apart, 0.8);
    }
  }
}

// Steps of one bin in either direction, each at what a change costs over none: their variance.
double VarianceOfSteps(const HeadingBins& bins, double width) {
  const double odds = std::exp(-bins.change_nats);
  return 2 * odds / (1 + 2 * odds) * width * width;
}

TEST(MakeBinsTest, OffsetsWanderAsTheirNoiseSays) {
  constexpr double kEpochS = 4;
  FactorSettings factors;
  factors.heading_offset.walk_rad_per_sqrt_s = 0.006;
  factors.heading_increment.sigma_rad_per_sqrt_s = 0.02;
  factors.gyro_bias.prior_sigma_radps = 0.005;
  const DiscreteSettings settings;
  const double width = settings.heading_bin_rad;
  const auto found = [&](HeadingSource source) {
    return VarianceOfSteps(MakeBins(source, factors, settings, kEpochS), width);
  };
  constexpr double kRelative = 1e-5;  // nats are floats
  const double compass = 0.006 * 0.006 * kEpochS;
  EXPECT_NEAR(found(HeadingSource::kAbsolute), compass, kRelative * compass);
  const double noise = 0.02 * 0.02 * kEpochS, bias = std::pow(0.005 * kEpochS, 2);
  EXPECT_NEAR(found(HeadingSource::kGyroscope), noise + bias, kRelative * (noise + bias));
  factors.gyro_bias.mode = StateMode::kAbsent;
  EXPECT_NEAR(found(HeadingSource::kGyroscope), noise, kRelative * noise);
}

TEST(MakeTransitionTest, NobodyStandsWhomNoAccelerometerSaw) {
  Evidence evidence;
  const DeadReckonedPath walk = DeadReckon(Site(), evidence, {});
  const TimeNs end = 4 * kNsPerSecond;
  FactorSettings factors;
  factors.standing.sigma_mps = 0.1;
  factors.standing.unseen_mps = 1.5;
  const double rounding = 1.5 * 1.5 / 6;  // of both ends to cells of 1.5 m
  EXPECT_NEAR(MakeTransition(evidence, walk, 0, end, factors, {}).variance_m2,
              std::pow(1.5 * 4, 2) + rounding, 1e-9);
  evidence.motion.push_back({0, end, MotionState::kStanding});
  EXPECT_NEAR(MakeTransition(evidence, walk, 0, end, factors, {}).variance_m2,
              0.1 * 0.1 * 4 + rounding, 1e-9);
}

// Between epochs the path runs along the dead reckoning, turned by the heading offset, and meets
// the cells at the epochs.
TEST(DiscretePathTest, FollowsTheTurnedWalkBetweenEpochs) {
  DeadReckonedPath walk;
  walk.source = HeadingSource::kGyroscope;
  walk.position_m.push_back(0, {0, 0});
  walk.position_m.push_back(2 * kNsPerSecond, {2, 0});
  walk.position_m.push_back(4 * kNsPerSecond, {2, 2});
  DiscretePath path;
  for (const TimeNs time : {TimeNs{0}, 4 * kNsPerSecond}) {
    path.position_m.push_back(time, time == 0 ? Eigen::Vector2d(10, 10) : Eigen::Vector2d(8, 12));
    path.heading_offset_rad.push_back(time, std::numbers::pi / 2);
  }
  // A quarter turn: 2 m along +y and then 2 m along -x.
  const auto expect_at = [&](double seconds, const Eigen::Vector2d& expected) {
    EXPECT_LT((path.PositionAt(walk, DurationNs(seconds)) - expected).norm(), 1e-9) << seconds;
  };
  expect_at(0, {10, 10});
  expect_at(1, {10, 11});
  expect_at(2, {10, 12});
  expect_at(3, {9, 12});
  expect_at(4, {8, 12});
  expect_at(-5, {10, 10});
  expect_at(9, {8, 12});
}

TEST(LatticeTest, CoversTheReachOfThePathInsideTheOutline) {
  Site site;
  site.building.floors.resize(1);
  site.building.floors[0].outline = {{{-10, -3}, {10, -3}, {10, 3}, {-10, 3}}};
  site.path = {{{0, 0}, 0, 0}, {{5, 0}, 0, 0}, {{0, 9}, 0, 0}, {{50, 0}, 4, 0}};
  const Lattice lattice(site, {0}, 1.0, 4.0);
  bool near_outlier = false;
  for (const Eigen::Vector2d& center : lattice.centers_m()) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
      nearest = std::min(nearest, (site.path[i].position_m - center).norm());
    }
    EXPECT_LE(nearest, 4.0);
    // Outside the outline only where somebody walked.
    if (std::abs(center.y()) > 3) {
      EXPECT_LE(nearest, 1.0 + 1e-9);
      near_outlier = true;
    }
  }
  EXPECT_TRUE(near_outlier);
  EXPECT_EQ(Lattice(site, {1}, 1.0, 4.0).size(), 0U);
}

TEST(LatticeTest, NeighboursAreCellsThatFarAway) {
  Site site;
  site.building.floors.resize(1);
  site.path = {{{0, 0}, 0, 0}, {{3, 1}, 0, 0}};
  const Lattice lattice(site, {0}, 1.5, 6.0);
  std::size_t missing = 0;
  for (std::size_t c = 0; c < lattice.size(); ++c) {
    for (const auto& [columns, rows] : {std::pair{1, 0}, {0, -1}, {-3, 2}, {40, 0}, {0, -40}}) {
      const auto cell = static_cast<std::int32_t>(c);
      const std::int32_t other = lattice.Neighbour(cell, columns, rows);
      const Eigen::Vector2d to = lattice.centers_m()[c] + 1.5 * Eigen::Vector2d(columns, rows);
      if (other == Lattice::kNoCell) {
        ++missing;
        for (const Eigen::Vector2d& center : lattice.centers_m()) {
          EXPECT_GT((center - to).norm(), 1.0);
        }
      } else {
        EXPECT_LT((lattice.centers_m()[static_cast<std::size_t>(other)] - to).norm(), 1e-9);
        EXPECT_EQ(lattice.Neighbour(other, -columns, -rows), cell);
      }
    }
  }
  EXPECT_GT(missing, 2 * lattice.size());
}

}  // namespace
}  // namespace walkgraph
