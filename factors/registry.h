#ifndef WALKGRAPH_FACTORS_REGISTRY_H_
#define WALKGRAPH_FACTORS_REGISTRY_H_

#include <string_view>
#include <vector>

#include "factors/absolute_heading.h"
#include "factors/area.h"
#include "factors/barometric.h"
#include "factors/fingerprint.h"
#include "factors/heading_increment.h"
#include "factors/level.h"
#include "factors/magnetic.h"
#include "factors/map_error.h"
#include "factors/position_hold.h"
#include "factors/prior.h"
#include "factors/random_walk.h"
#include "factors/step.h"

namespace walkgraph {

template <typename... Factors>
struct FactorList {};

// Every factor type of the project. The tests of tests/factors run over all of them.
using RegisteredFactors =
    FactorList<StepFactor, HeadingIncrementFactor, AbsoluteHeadingFactor, PositionHoldFactor,
               FingerprintFactor, HearingFactor, MagneticFactor, RandomWalkFactor,
               MapErrorFactor<2>, StatePriorFactor, PositionAnchorFactor, BarometricFactor,
               LevelFactor, AreaFactor>;

struct FactorInfo {
  std::string_view name;
  std::string_view description;  // one sentence for `walkgraph config` and the report
};

// The registered types in the order of the list.
const std::vector<FactorInfo>& FactorRegistry();

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_REGISTRY_H_
