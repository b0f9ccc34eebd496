#ifndef WALKGRAPH_FRONTENDS_SIGNAL_H_
#define WALKGRAPH_FRONTENDS_SIGNAL_H_

#include <Eigen/Core>
#include <vector>

#include "data/recording.h"

namespace walkgraph {

// Mean of the samples within half a window before and after each sample. Zero-phase, so that peaks
// stay where they are; truncated at the ends; any sampling. Times must not decrease. Linear time.
std::vector<double> CenteredMean(const std::vector<TimeNs>& time_ns,
                                 const std::vector<double>& value, double window_s);
std::vector<Eigen::Vector3d> CenteredMean(const std::vector<TimeNs>& time_ns,
                                          const std::vector<Eigen::Vector3d>& value,
                                          double window_s);

// The stream at other times (not decreasing), linear between samples, clamped at the ends. Linear
// time. Empty where the stream is empty.
std::vector<Eigen::Vector3d> Resample(const Stream<Eigen::Vector3d>& stream,
                                      const std::vector<TimeNs>& time_ns);
std::vector<double> Resample(const Stream<double>& stream, const std::vector<TimeNs>& time_ns);

// Whole turns added so that neighbours differ by less than half a turn.
void Unwrap(std::vector<double>* angle_rad);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_SIGNAL_H_
