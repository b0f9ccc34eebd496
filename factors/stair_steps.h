#ifndef WALKGRAPH_FACTORS_STAIR_STEPS_H_
#define WALKGRAPH_FACTORS_STAIR_STEPS_H_

#include "factors/floor_path.h"
#include "factors/settings.h"
#include "frontends/evidence/evidence.h"

namespace walkgraph {

// Gives steps between levels (by their middle) the length of a tread, `settings.tread_m`: the body
// swings no less on stairs than on a level, so that a model of the swing takes them for strides of
// twice the length. Steps that are shorter anyway keep their own; with a tread of 0 all do.
void ShortenStairSteps(const FloorPath& floors, const StepSettings& settings, Evidence* evidence);

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_STAIR_STEPS_H_
