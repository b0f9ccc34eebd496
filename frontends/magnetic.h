#ifndef WALKGRAPH_FRONTENDS_MAGNETIC_H_
#define WALKGRAPH_FRONTENDS_MAGNETIC_H_

#include <Eigen/Core>

#include "data/recording.h"
#include "frontends/evidence/evidence.h"

namespace walkgraph {

// Norm (microtesla) and inclination (radians below the horizontal plane) of the field at every
// magnetometer sample; a zero field has inclination 0. Empty without `up` (see EstimateUp).
Stream<MagneticSample> MagneticField(const Stream<Eigen::Vector3d>& magnetometer_ut,
                                     const Stream<Eigen::Vector3d>& up);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_MAGNETIC_H_
