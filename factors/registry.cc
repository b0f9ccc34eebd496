#include "factors/registry.h"

namespace walkgraph {

const std::vector<FactorInfo>& FactorRegistry() {
  static const std::vector<FactorInfo> kRegistry = {
      {StepFactor::kName, "a detected step moves the position along the heading"},
      {HeadingIncrementFactor::kName, "the heading turns as the gyroscope did"},
      {AbsoluteHeadingFactor::kName, "the heading is the compass's, up to a slow offset"},
      {PositionHoldFactor::kName, "the position holds while nobody walks"},
      {FingerprintFactor::kName, "received signal strengths fit the radio map"},
      {HearingFactor::kName, "the transmitters heard and not heard fit the radio map"},
      {MagneticFactor::kName, "the magnetic field fits the magnetic map"},
      {RandomWalkFactor::kName, "a slow state drifts from knot to knot"},
      {MapErrorFactor<2>::kName, "a map errs alike at places that are close"},
      {StatePriorFactor::kName, "a slow state before the walk"},
      {PositionAnchorFactor::kName, "a surveyed point was passed"},
      {BarometricFactor::kName, "the height is the barometer's, up to a slow offset"},
      {LevelFactor::kName, "on a level the height is the level's"},
      {AreaFactor::kName, "people are where the plan or the survey says that people walk"},
  };
  return kRegistry;
}

}  // namespace walkgraph
