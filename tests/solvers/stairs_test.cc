#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "solvers/batch_smoother.h"
#include "solvers/two_floors.h"
#include "solvers/window_smoother.h"

namespace walkgraph {
namespace {

using testing::TwoFloors;

constexpr double kStrideM = 0.7, kStepS = 0.6, kClimbS = 12;

// A minute on the ground floor at a surveyed tag, then straight up the stairs to the next.
Evidence Climb(TwoFloors* house) {
  Evidence evidence = house->Ride(TwoFloors::Stays({0, 1}, 60, kClimbS), 250.0);
  evidence.anchors.push_back({TwoFloors::At(30), {5, 10}, 0, 0.1});
  evidence.motion = {{evidence.begin_ns, TwoFloors::At(60), MotionState::kStanding},
                     {TwoFloors::At(60), TwoFloors::At(60 + kClimbS), MotionState::kWalking},
                     {TwoFloors::At(60 + kClimbS), evidence.end_ns, MotionState::kStanding}};
  for (double t = 60; t < 60 + kClimbS - 0.1; t += kStepS) {
    evidence.steps.push_back({TwoFloors::At(t), TwoFloors::At(t + kStepS), kStrideM});
  }
  for (double t = 0; TwoFloors::At(t) <= evidence.end_ns; t += 0.2) {
    evidence.absolute_heading_rad.push_back(TwoFloors::At(t), 0.0);
    evidence.absolute_heading_sigma_rad.push_back(0.05);
  }
  return evidence;
}

double Climbed(const EstimateResult& result) {
  return (result.trajectory.poses.back().position_m -
          result.trajectory.At(TwoFloors::At(30)).position_m)
      .head<2>()
      .norm();
}

// The ends of the climb may count as level.
TEST(Stairs, AreAsLongAsTheirTreads) {
  const double strides_m = kClimbS / kStepS * kStrideM;
  const double treads_m = kClimbS / kStepS * StepSettings().tread_m;
  FactorSettings level;
  level.step.tread_m = 0;
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    TwoFloors house(seed);
    const Evidence climb = Climb(&house);
    for (const EstimateResult& result : {BatchSmoother({}, {}).Estimate(house.site, climb),
                                         WindowSmoother({}, {}, {}).Estimate(house.site, climb)}) {
      EXPECT_NEAR(Climbed(result), treads_m, 0.3 * (strides_m - treads_m)) << "seed " << seed;
    }
    EXPECT_NEAR(Climbed(BatchSmoother(level, {}).Estimate(house.site, climb)), strides_m, 1.0);
  }
}

}  // namespace
}  // namespace walkgraph
