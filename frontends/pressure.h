#ifndef WALKGRAPH_FRONTENDS_PRESSURE_H_
#define WALKGRAPH_FRONTENDS_PRESSURE_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "data/recording.h"
#include "frontends/settings.h"

namespace walkgraph {

// The barometer's samples in hPa. Phone barometers reach from 300 to 1100 hPa (the top of Everest
// to the Dead Sea), so that a value tells its own unit: where most are in Pa or in kPa all are
// converted and counted, as "pressure_in_pa" or "pressure_in_kpa". Samples that are no pressure in
// the stream's unit are dropped and counted as "pressure_out_of_range". Where a sensor repeats one
// value for longer than the settings' limit it is stuck: these samples are dropped and counted as
// "pressure_constant".
Stream<double> CheckPressure(const Stream<double>& pressure, const PressureSettings& settings,
                             std::map<std::string, std::int64_t>* counts);

// Height by the barometer, a mean over each interval of settings.mean_s at the mean of its times,
// and the standard error of each mean by the spread of its samples: what the sensor itself errs,
// without weather and draughts.
struct HeightStream {
  Stream<double> height_m;
  std::vector<double> sigma_m;  // one per height
};

// The recording's checked pressure as heights. A barometer that falls silent more than
// settings.silent_s before the recording's end is counted as "pressure_stopped_s", the seconds that
// it missed.
HeightStream BarometricHeight(const Recording& recording, const PressureSettings& settings,
                              std::map<std::string, std::int64_t>* counts);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_PRESSURE_H_
