#include "solvers/floor_by_floor.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "solvers/two_floors.h"

namespace walkgraph {
namespace {

using testing::TwoFloors;

// Says that the walk stood at (floor, 0), and keeps the evidence on which it was asked.
class Probe : public Estimator {
 public:
  Probe(std::vector<Evidence>* asked, EstimateStatus status) : asked_(asked), status_(status) {}
  std::string_view name() const override { return "probe"; }
  EstimateResult Estimate(const Site&, const Evidence& evidence) const override {
    asked_->push_back(evidence);
    EstimateResult result;
    result.status = status_;
    result.messages = {"asked"};
    for (const TimeNs time_ns : {evidence.begin_ns, evidence.end_ns}) {
      PoseEstimate pose;
      pose.time_ns = time_ns;
      pose.floor = *evidence.floor;
      pose.position_m.x() = *evidence.floor;
      result.trajectory.poses.push_back(pose);
    }
    return result;
  }

 private:
  std::vector<Evidence>* asked_;
  EstimateStatus status_;
};

struct Ride {
  TwoFloors house{3};
  Evidence evidence = house.Ride(TwoFloors::Stays({0, 1}, 60, 10), 20.0);
};

TEST(FloorByFloor, AsksOncePerStayAndJoinsTheAnswers) {
  Ride ride;
  std::vector<Evidence> asked;
  const FloorByFloor method(std::make_unique<Probe>(&asked, EstimateStatus::kOk), {});
  const EstimateResult result = method.Estimate(ride.house.site, ride.evidence);
  ASSERT_EQ(asked.size(), 2U);
  EXPECT_EQ(result.status, EstimateStatus::kOk);
  EXPECT_EQ(result.messages, std::vector<std::string>{"asked"});
  EXPECT_EQ(result.trajectory.At(TwoFloors::At(20)).position_m.x(), 0);
  EXPECT_EQ(result.trajectory.At(TwoFloors::At(20)).floor, 0);
  EXPECT_EQ(result.trajectory.At(TwoFloors::At(110)).position_m.x(), 1);
  EXPECT_EQ(result.trajectory.At(TwoFloors::At(110)).floor, 1);
  // Every part has what was heard in its time, and nothing else.
  for (const Evidence& part : asked) {
    ASSERT_FALSE(part.readings.empty());
    for (const RadioReading& reading : part.readings) {
      EXPECT_GE(reading.heard_ns, part.begin_ns);
      EXPECT_LE(reading.heard_ns, part.end_ns);
    }
  }
  EXPECT_LE(asked[0].end_ns, asked[1].begin_ns);
}

TEST(FloorByFloor, LeavesAGivenFloorAlone) {
  Ride ride;
  ride.evidence.floor = 1;
  std::vector<Evidence> asked;
  const FloorByFloor method(std::make_unique<Probe>(&asked, EstimateStatus::kOk), {});
  method.Estimate(ride.house.site, ride.evidence);
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_EQ(asked[0].readings.size(), ride.evidence.readings.size());
}

TEST(FloorByFloor, SaysWhatIsMissingWhereNoStayHasIt) {
  Ride ride;
  std::vector<Evidence> asked;
  const FloorByFloor method(std::make_unique<Probe>(&asked, EstimateStatus::kUnsupported), {});
  EXPECT_EQ(method.Estimate(ride.house.site, ride.evidence).status, EstimateStatus::kUnsupported);
}

}  // namespace
}  // namespace walkgraph
