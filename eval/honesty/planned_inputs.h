#ifndef WALKGRAPH_EVAL_HONESTY_PLANNED_INPUTS_H_
#define WALKGRAPH_EVAL_HONESTY_PLANNED_INPUTS_H_

#include "data/simulator/random.h"
#include "frontends/evidence/evidence.h"

namespace walkgraph {

inline constexpr double kPlannedSpeedMps = 0.7 / 0.55;  // steps of 0.7 m, each 0.55 s

// Steps, motion states and gyroscope yaw of a tour of straight legs, right-angled turns, turns back
// and pauses that dead reckoning sees stay within some 12 m of its start. Nothing here depends on
// where the walk truly goes: to the model these are inputs, not measurements.
Evidence PlanInputs(double duration_s, Random* random);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_HONESTY_PLANNED_INPUTS_H_
