#ifndef WALKGRAPH_EVAL_CALIBRATE_SENSOR_NOISE_H_
#define WALKGRAPH_EVAL_CALIBRATE_SENSOR_NOISE_H_

#include <vector>

#include "eval/calibrate/calibrated_values.h"
#include "factors/settings.h"

namespace walkgraph {

// Each sets what it names and appends it to `values`; where fewer than ten walks or samples bear on
// a setting, or they show nothing of it, it keeps its default and is not appended.

// Spread of the gyroscope's bias over walks, from the drift of absolute heading against integrated
// yaw.
void CalibrateGyroscopeBias(const std::vector<CalibrationWalk>& walks, GyroBiasSettings* settings,
                            std::vector<CalibratedValue>* values);

// Error of a height by the barometer, beyond what the evidence says of its samples, and the drift
// of its offset: of heights on one floor, between waypoints that are all on it, the squared
// difference is 2 error + rate x time apart.
void CalibrateBarometer(const std::vector<CalibrationWalk>& walks, BarometricSettings* barometer,
                        BarometricOffsetSettings* offset, std::vector<CalibratedValue>* values);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_CALIBRATE_SENSOR_NOISE_H_
