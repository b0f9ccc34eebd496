#ifndef WALKGRAPH_FRONTENDS_YAW_H_
#define WALKGRAPH_FRONTENDS_YAW_H_

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <string>

#include "data/recording.h"
#include "frontends/settings.h"

namespace walkgraph {

// Integral of the angular rate about the vertical (trapezoid), radians counter-clockwise seen from
// above, unwrapped, 0 at the first gyroscope sample. Breaks longer than the settings' limit are
// bridged with the mean of the rates at both ends and counted as "gyroscope_gap". Empty without
// gyroscope or without `up` (see EstimateUp).
Stream<double> IntegrateYaw(const Stream<Eigen::Vector3d>& gyroscope_radps,
                            const Stream<Eigen::Vector3d>& up, const YawSettings& settings,
                            std::map<std::string, std::int64_t>* counts);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_YAW_H_
