#ifndef WALKGRAPH_FRONTENDS_STEP_CONFIRMATION_H_
#define WALKGRAPH_FRONTENDS_STEP_CONFIRMATION_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "data/recording.h"
#include "frontends/settings.h"

namespace walkgraph {

// A peak of the gait signal with the valleys on both sides of it.
struct StepPeak {
  TimeNs time_ns = 0;
  double value = 0;  // m/s^2
  TimeNs valley_before_ns = 0;
  TimeNs valley_after_ns = 0;
  double lowest_valley = 0;
  double threshold = 0;  // the swing it has to have

  double Swing() const { return value - lowest_valley; }
};

// The frequency (Hz) between 1 and 3 Hz at which the Fourier transform of the gait signal within
// [begin, end] is largest. Any sampling. None where the span holds under two periods of 1 Hz or the
// signal is zero.
std::optional<double> WalkingFrequency(const Stream<double>& gait, TimeNs begin_ns, TimeNs end_ns);

// Steps come at the walking frequency (DSFF): of two peaks closer than 0.6 of its period the lower
// one goes ("step_unconfirmed"), and where the time between two peaks is that of n steps, n at most
// 3, n - 1 like them are put between ("step_from_frequency"). The frequency is that of the
// settings' window around each peak.
std::vector<StepPeak> ConfirmByFrequency(const Stream<double>& gait,
                                         const std::vector<StepPeak>& peaks,
                                         const StepDetectorSettings& settings,
                                         std::map<std::string, std::int64_t>* counts);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_STEP_CONFIRMATION_H_
