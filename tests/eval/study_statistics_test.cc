// Every statistic of a study of twelve walks, computed again by plain arithmetic; and the bootstrap
// on synthetic studies whose mean is known.
#include "eval/study/study_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "eval/random.h"
#include "eval/study/study_output.h"
#include "eval/study/walk_cells.h"

namespace walkgraph {
namespace {

constexpr double kExact = 1e-12;

WaypointError Error(double metres, double nees, int floors_off) {
  WaypointError error;
  error.error_m = metres;
  error.nees = nees;
  error.floors_off = floors_off;
  error.claimed_m = 1 + nees;
  return error;
}

// Twelve walks of one or two waypoints; cell "b" did not place the last walk.
StudyResults TwelveWalks() {
  StudyResults results;
  results.record.cells = {{"a", "batch", {}, "1", "base"}, {"b", "batch", {}, "2", "base"}};
  results.record.reference = "a";
  results.datasets.push_back({"d", {}});
  for (int i = 0; i < 12; ++i) {
    WalkCells walk;
    walk.walk = "w" + std::to_string(i);
    walk.device = i % 2 == 0 ? "p" : "q";
    walk.survey_distance_m = i < 9 ? 1 : 5;
    walk.cells = {{"a", "1", EstimateStatus::kOk, {}, {}}, {"b", "2", EstimateStatus::kOk, {}, {}}};
    for (int k = 0; k <= i % 2; ++k) {
      walk.waypoints.push_back({10.0 * k, 0, 20.0 * k, k == 0 ? NAN : 0.5});
      walk.cells[0].errors.push_back(Error(1 + 0.25 * i + k, 0.5 * i, 0));
      walk.cells[1].errors.push_back(Error(2 + 0.125 * i * i - k, 0.25 * i, i == 3 ? 1 : 0));
      walk.centroid_errors.push_back(Error(50, NAN, 0));
    }
    if (i == 11) {
      walk.cells[1].errors.clear();
      walk.cells[1].status = EstimateStatus::kUnobservable;
    }
    results.datasets[0].walks.push_back(std::move(walk));
  }
  return results;
}

// Errors of a cell over all waypoints, written out from the rule above.
std::vector<double> ErrorsByHand(int cell) {
  std::vector<double> errors;
  for (int i = 0; i < 12; ++i) {
    for (int k = 0; k <= i % 2; ++k) {
      const double a = 1 + 0.25 * i + k, b = i == 11 ? 50 : 2 + 0.125 * i * i - k;
      errors.push_back(cell == 0 ? a : b);
    }
  }
  return errors;
}

TEST(StudyStatistics, EqualPlainArithmetic) {
  const DatasetStatistics d = ComputeStatistics(TwelveWalks()).front();
  const StudySection& all = d.sections.front();
  ASSERT_EQ(all.name, "all");
  for (int cell = 0; cell < 2; ++cell) {
    const CellStatistics& found = all.cells[static_cast<std::size_t>(cell)];
    std::vector<double> errors = ErrorsByHand(cell);
    ASSERT_EQ(errors.size(), 18u);
    double sum = 0, squares = 0;
    for (const double e : errors) sum += e, squares += e * e;
    std::sort(errors.begin(), errors.end());
    EXPECT_EQ(found.walks, 12);
    EXPECT_EQ(found.errors.n, 18);
    EXPECT_NEAR(found.errors.mean_m, sum / 18, kExact);
    EXPECT_NEAR(found.errors.rmse_m, std::sqrt(squares / 18), kExact);
    EXPECT_NEAR(found.errors.median_m, (errors[8] + errors[9]) / 2, kExact);
    EXPECT_NEAR(found.errors.p75_m, errors[12] + 0.75 * (errors[13] - errors[12]), kExact);
    EXPECT_NEAR(found.errors.p90_m, errors[15] + 0.3 * (errors[16] - errors[15]), kExact);
    EXPECT_NEAR(found.errors.p95_m, errors[16] + 0.15 * (errors[17] - errors[16]), kExact);
    EXPECT_NEAR(found.errors.max_m, errors[17], kExact);
  }
  EXPECT_NEAR(all.cells[1].errors.floor_accuracy, 16.0 / 18, kExact);  // walk 3 has two waypoints
  // NEES of "a": 0.5 i, once for even walks and twice for odd ones: (30 + 2 * 36) / 2 / 18.
  EXPECT_NEAR(all.cells[0].errors.nees, (30 + 2 * 36) / 2.0 / 18, kExact);
  // Inside 95 % where 0.5 i <= -2 log 0.05 = 5.99: all walks. Inside 50 % where 0.5 i <= 1.386: 0,
  // 1, 2.
  EXPECT_NEAR(all.cells[0].errors.coverage95, 1, kExact);
  EXPECT_NEAR(all.cells[0].errors.coverage50, 4.0 / 18, kExact);
}

TEST(StudyStatistics, PairedComparisonEqualsPlainArithmetic) {
  const DatasetStatistics d = ComputeStatistics(TwelveWalks()).front();
  const ComparedWithReference& found = d.sections.front().cells[1].compared;
  const std::vector<double> a = ErrorsByHand(0), b = ErrorsByHand(1);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += b[i] - a[i];
  EXPECT_NEAR(found.mean_m, sum / 18, kExact);
  // Differences of the walks' means: 1 + i^2/8 - i/4 for even walks, k lowers those of odd ones by
  // 1: 1, -0.125, 1, 0.375, 2, 1.875, 4, 4.375, 7, 7.875, 11, then 50 - 4.25. One is negative, and
  // its magnitude is the smallest: W+ = 78 - 1.
  EXPECT_EQ(found.test.n, 12);
  EXPECT_NEAR(found.test.w_plus, 77, kExact);
  EXPECT_NEAR(found.test.p_value, 2 * 2.0 / 4096, kExact);     // W- of 0 or 1
  EXPECT_NEAR(found.corrected_p, found.test.p_value, kExact);  // the only test
  EXPECT_TRUE(std::isnan(d.sections.front().cells[0].compared.mean_m));
}

TEST(StudyStatistics, SectionsAndBreakdownSelectWalksAndWaypoints) {
  const DatasetStatistics d = ComputeStatistics(TwelveWalks()).front();
  EXPECT_EQ(d.sections[1].name, "covered");
  EXPECT_EQ(d.sections[1].cells[0].walks, 9);
  EXPECT_EQ(d.sections[2].name, "placed");
  EXPECT_EQ(d.sections[2].cells[0].walks, 11);
  EXPECT_EQ(d.status[1].at("unobservable"), 1);
  const auto Row = [&](const std::string& by, const std::string& value) {
    for (const BreakdownRow& row : d.breakdown) {
      if (row.by == by && row.value == value) return row;
    }
    ADD_FAILURE() << by << " " << value;
    return BreakdownRow();
  };
  EXPECT_EQ(Row("distance walked, m", "0 to 10").cells[0].n, 12);
  EXPECT_EQ(Row("distance walked, m", "10 to 25").cells[0].n, 6);
  EXPECT_EQ(Row("since the last scan, s", "none").walks, 12);
  EXPECT_EQ(Row("since the last scan, s", "0 to 1").cells[0].n, 6);
  EXPECT_EQ(Row("phone", "p").walks, 6);
  // Second waypoints of walks 1, 3, ... 11: 2 + i / 4 with i = 6 on average.
  EXPECT_NEAR(Row("epoch, s", "0 to 15").cells[0].mean_m, (18 * 1.0 + 6 + 0.25 * 102) / 18, kExact);
}

// With two factors the Shapley values are the two orders' mean.
TEST(StudyStatistics, ContributionsAreShapleyValuesOfTheMean) {
  StudyResults results = TwelveWalks();
  results.record.factors = {"x", "y"};
  results.record.cells = {{"none", "", {}, "", ""},
                          {"x", "", {}, "", ""},
                          {"y", "", {}, "", ""},
                          {"all", "", {}, "", ""}};
  results.record.reference = "all";
  results.record.cell_of_subset = {{0, 0}, {1, 1}, {2, 2}, {3, 3}};
  constexpr double kMean[] = {10, 7, 9, 4};
  for (WalkCells& walk : results.datasets[0].walks) {
    walk.cells.clear();
    for (const double mean : kMean) {
      walk.cells.push_back({"", "", EstimateStatus::kOk, {}, {}});
      for (std::size_t k = 0; k < walk.waypoints.size(); ++k) {
        walk.cells.back().errors.push_back(Error(mean, 1, 0));
      }
    }
  }
  const auto found = ComputeStatistics(results).front().contributions;
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].removes_m, 0.5 * ((10 - 7) + (9 - 4)), kExact);
  EXPECT_NEAR(found[1].removes_m, 0.5 * ((10 - 9) + (7 - 4)), kExact);
  EXPECT_NEAR(found[0].interval_m.high, found[0].removes_m, kExact);  // all walks alike
}

TEST(FormatP, NeverSaysNought) {
  EXPECT_EQ(FormatP(0), "< 0.0001");
  EXPECT_EQ(FormatP(9.9e-5), "< 0.0001");
  EXPECT_EQ(FormatP(1e-4), "0.0001");
  EXPECT_EQ(FormatP(0.6262), "0.6262");
  EXPECT_EQ(FormatP(std::nan("")), "-");
}

TEST(WalkCells, ReadBackToTheSameBits) {
  WalkCells walk = TwelveWalks().datasets[0].walks[11];
  walk.survey_distance_m = INFINITY;
  walk.cells[0].errors[0].error_m = 0.1 + 0.2;
  walk.cells[0].messages = {"a \"quoted\" line\n"};
  const std::string text = FormatWalkCells(walk);
  const auto back = ParseWalkCells(text);
  ASSERT_TRUE(back);
  EXPECT_EQ(FormatWalkCells(*back), text);
  EXPECT_EQ(back->cells[0].errors[0].error_m, 0.1 + 0.2);
  EXPECT_TRUE(std::isinf(back->survey_distance_m));
  EXPECT_FALSE(ParseWalkCells(text.substr(0, text.size() / 2)));
  EXPECT_FALSE(ParseWalkCells(""));
}

// A thousand studies of 60 walks: walks have a mean of their own (gamma-like, skewed as errors
// are) and 1 to 12 waypoints about it. The true mean over waypoints is known.
TEST(Bootstrap, CoversTheTrueMeanOfSyntheticStudies) {
  SplitMix64 random(99);
  const auto Exponential = [&] {
    return -std::log((static_cast<double>(random.Index(1000000)) + 0.5) / 1e6);
  };
  int covered = 0;
  constexpr int kStudies = 1000, kWalks = 60;
  for (int study = 0; study < kStudies; ++study) {
    std::vector<WalkTotal> walks;
    for (int i = 0; i < kWalks; ++i) {
      const int n = 1 + static_cast<int>(random.Index(12));
      const double mean = Exponential() + Exponential() + Exponential();
      WalkTotal total{0, n};
      for (int k = 0; k < n; ++k) total.sum += mean + Exponential() - 1;
      walks.push_back(total);
    }
    const Interval interval = BootstrapMean(walks);
    covered += interval.low <= 3 && 3 <= interval.high ? 1 : 0;
  }
  EXPECT_GE(covered, 930);
  EXPECT_LE(covered, 970);
}

}  // namespace
}  // namespace walkgraph
