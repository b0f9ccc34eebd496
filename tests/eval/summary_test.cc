#include "eval/summary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace walkgraph {
namespace {

WaypointError Error(double metres, int floor = 0) {
  WaypointError error;
  error.error_m = metres;
  error.floor = floor;
  return error;
}

MethodOutcome Outcome(std::vector<WaypointError> errors) {
  MethodOutcome outcome;
  outcome.status = EstimateStatus::kOk;
  outcome.has_trajectory = !errors.empty();
  outcome.errors = std::move(errors);
  return outcome;
}

WalkOutcome WalkOf(double survey_distance_m, std::vector<WaypointError> a,
                   std::vector<WaypointError> b, std::vector<WaypointError> centroid) {
  WalkOutcome walk;
  walk.finished = true;
  walk.survey_distance_m = survey_distance_m;
  for (const WaypointError& error : centroid)
    walk.truth.waypoints.push_back({0, {0, 0}, error.floor});
  walk.centroid_errors = std::move(centroid);
  walk.methods = {Outcome(std::move(a)), Outcome(std::move(b))};
  return walk;
}

const SummaryRow& Row(const std::vector<SummarySection>& sections, const std::string& section,
                      std::size_t method) {
  for (const SummarySection& candidate : sections) {
    if (candidate.name == section) return candidate.rows.at(method);
  }
  throw std::runtime_error("no section " + section);
}

// Three walks: covered on floor 0; far from the survey on floors 0 and 1; one that "b" did not
// place.
Evaluation ThreeWalks() {
  Evaluation evaluation;
  evaluation.methods = {"a", "b"};
  evaluation.walks = {
      WalkOf(1, {Error(1), Error(3)}, {Error(2), Error(4)}, {Error(20), Error(20)}),
      WalkOf(5, {Error(8), Error(10, 1)}, {Error(7), Error(7, 1)}, {Error(30), Error(30, 1)}),
      WalkOf(1, {Error(2)}, {}, {Error(40)})};
  return evaluation;
}

TEST(Summary, PoolsWalksThatEveryMethodPlaced) {
  const auto sections = SummariseEvaluation(ThreeWalks(), {{0, "G"}, {1, "U"}});
  EXPECT_EQ(Row(sections, "pooled", 0).walks, 2);
  EXPECT_EQ(Row(sections, "pooled", 0).errors.n, 4);
  EXPECT_NEAR(Row(sections, "pooled", 0).errors.mean_m, 22.0 / 4, 1e-12);
  EXPECT_NEAR(Row(sections, "pooled", 1).errors.mean_m, 20.0 / 4, 1e-12);
}

TEST(Summary, CoveredWalksAndFloorsAreRowsOfTheirOwn) {
  const auto sections = SummariseEvaluation(ThreeWalks(), {{0, "G"}, {1, "U"}});
  EXPECT_NEAR(Row(sections, "covered", 0).errors.mean_m, 2, 1e-12);
  EXPECT_NEAR(Row(sections, "floor G", 0).errors.mean_m, 4, 1e-12);  // 1, 3 and 8
  EXPECT_EQ(Row(sections, "floor U", 1).walks, 1);
  EXPECT_NEAR(Row(sections, "floor U", 1).errors.mean_m, 7, 1e-12);
}

bool HasSection(const std::vector<SummarySection>& sections, const std::string& name) {
  return std::any_of(sections.begin(), sections.end(),
                     [&](const SummarySection& section) { return section.name == name; });
}

TEST(Summary, StandingAndWalkingAreRowsOfTheirOwnWhereBothOccur) {
  Evaluation evaluation = ThreeWalks();
  EXPECT_FALSE(HasSection(SummariseEvaluation(evaluation, {}), "walking"));
  evaluation.walks[0].motion = {MotionState::kStanding, MotionState::kWalking};
  evaluation.walks[1].motion = {MotionState::kHandling, MotionState::kWalking};
  evaluation.walks[2].motion = {MotionState::kStanding};  // not pooled
  const auto sections = SummariseEvaluation(evaluation, {});
  EXPECT_NEAR(Row(sections, "standing", 1).errors.mean_m, 2, 1e-12);
  EXPECT_EQ(Row(sections, "walking", 0).errors.n, 2);
  EXPECT_NEAR(Row(sections, "walking", 0).errors.mean_m, (3.0 + 10.0) / 2, 1e-12);
}

// Each method at its own trusted points.
TEST(Summary, TrustedPointsAreRowsOfTheMethodsThatHaveThem) {
  Evaluation evaluation = ThreeWalks();
  EXPECT_FALSE(HasSection(SummariseEvaluation(evaluation, {}), "trusted"));
  evaluation.walks[0].methods[1].trusted = {false, true};
  evaluation.walks[1].methods[1].trusted = {true, true};
  const auto one = SummariseEvaluation(evaluation, {});
  EXPECT_EQ(Row(one, "trusted", 0).method, "b");
  EXPECT_EQ(Row(one, "trusted", 0).walks, 2);
  EXPECT_NEAR(Row(one, "trusted", 0).errors.mean_m, (4.0 + 7.0 + 7.0) / 3, 1e-12);
  evaluation.walks[0].methods[0].trusted = {true, false};
  const auto both = SummariseEvaluation(evaluation, {});
  EXPECT_NEAR(Row(both, "trusted", 0).errors.mean_m, 1, 1e-12);
  EXPECT_EQ(Row(both, "trusted", 1).errors.n, 3);
}

TEST(Summary, AMissingOutputCountsAsTheCentroidOverAllWalks) {
  const auto sections = SummariseEvaluation(ThreeWalks(), {});
  EXPECT_EQ(Row(sections, "all_walks", 0).errors.n, 5);
  EXPECT_NEAR(Row(sections, "all_walks", 0).errors.mean_m, 24.0 / 5, 1e-12);
  EXPECT_NEAR(Row(sections, "all_walks", 1).errors.mean_m, 60.0 / 5, 1e-12);
}

TEST(Summary, DifferencesArePaired) {
  const auto sections = SummariseEvaluation(ThreeWalks(), {});
  const PairedDifference& difference = sections.front().differences.front();
  EXPECT_EQ(difference.method, "a");
  EXPECT_EQ(difference.other, "b");
  EXPECT_NEAR(difference.mean_m, 22.0 / 4 - 20.0 / 4, 1e-12);
  // Resamples of two walks lie between the two walks' own differences, -1 and 2.
  EXPECT_NEAR(difference.interval_m.low, -1, 1e-12);
  EXPECT_NEAR(difference.interval_m.high, 2, 1e-12);
}

TEST(Summary, UnfinishedWalksCountNowhere) {
  Evaluation evaluation = ThreeWalks();
  evaluation.walks[1] = WalkOutcome();
  const auto sections = SummariseEvaluation(evaluation, {});
  EXPECT_EQ(Row(sections, "pooled", 0).walks, 1);
  EXPECT_EQ(Row(sections, "all_walks", 0).walks, 2);
}

}  // namespace
}  // namespace walkgraph
