#ifndef WALKGRAPH_FRONTENDS_STEPS_H_
#define WALKGRAPH_FRONTENDS_STEPS_H_

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "data/recording.h"
#include "frontends/evidence/evidence.h"
#include "frontends/motion.h"
#include "frontends/settings.h"

namespace walkgraph {

// Vertical acceleration without gravity, limited to the band of steps, m/s^2, zero-phase. Times are
// the accelerometer's. Empty without accelerometer or `up`.
Stream<double> GaitSignal(const Stream<Eigen::Vector3d>& accelerometer_mps2,
                          const Stream<Eigen::Vector3d>& up, const StepDetectorSettings& settings);

// Steps of a gait signal: its peaks between zero crossings (with hysteresis, so that the second
// bump of a heel strike is no crossing) whose swing from peak to valley is a fair part of the local
// swing and more than a standing person's. A step lasts from the valley before its peak to the
// valley after it; the first and last of a run take half an interval outwards. Length after
// Weinberg ("Using the ADXL202 in pedometer and personal navigation applications", AN-602, 2002): K
// swing^(1/4). Peaks inside `handling` and peaks without a neighbour are no steps; both are counted
// ("step_while_handling", "step_alone"). Linear time. With settings.fourier_confirmation the peaks
// are confirmed by the walking frequency (see ConfirmByFrequency).
std::vector<StepEvidence> DetectSteps(const Stream<double>& gait,
                                      const std::vector<TimeSpan>& handling,
                                      const StepDetectorSettings& settings,
                                      std::map<std::string, std::int64_t>* counts);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_STEPS_H_
