#ifndef WALKGRAPH_FRONTENDS_GRAVITY_H_
#define WALKGRAPH_FRONTENDS_GRAVITY_H_

#include <Eigen/Core>
#include <vector>

#include "data/recording.h"
#include "frontends/settings.h"

namespace walkgraph {

inline constexpr double kStandardGravityMps2 = 9.80665;

// Unit vector towards the sky in device axes at every accelerometer sample: turned by the gyroscope
// (kept where there is none) and pulled to the specific force with the settings' time constant
// (complementary filter, e.g. Mahony et al., IEEE TAC 53, 2008). Empty without accelerometer; where
// nothing but free fall was measured yet, the phone is taken to lie flat.
Stream<Eigen::Vector3d> EstimateUp(const Recording& recording,
                                   const GravityFilterSettings& settings);

// The up vector at other times, unit length. Empty where `up` is.
std::vector<Eigen::Vector3d> UpAt(const Stream<Eigen::Vector3d>& up,
                                  const std::vector<TimeNs>& time_ns);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_GRAVITY_H_
