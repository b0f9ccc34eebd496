#include "factors/stair_steps.h"

#include <algorithm>

namespace walkgraph {

void ShortenStairSteps(const FloorPath& floors, const StepSettings& settings, Evidence* evidence) {
  if (settings.tread_m <= 0 || floors.stays().size() < 2) return;
  for (StepEvidence& step : evidence->steps) {
    const TimeNs middle_ns = step.begin_ns + (step.end_ns - step.begin_ns) / 2;
    if (floors.OnLevel(middle_ns)) continue;
    step.length_m = std::min(step.length_m, settings.tread_m);
  }
}

}  // namespace walkgraph
