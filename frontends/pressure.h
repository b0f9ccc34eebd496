#ifndef WALKGRAPH_FRONTENDS_PRESSURE_H_
#define WALKGRAPH_FRONTENDS_PRESSURE_H_

#include <cstdint>
#include <map>
#include <string>

#include "data/recording.h"
#include "frontends/settings.h"

namespace walkgraph {

// The barometer's plausible samples. Outside 300-1100 hPa (the range of phone barometers, from the
// top of Everest to the Dead Sea) samples are dropped and counted: as "pressure_in_pa" or
// "pressure_in_kpa" where another unit explains the value, else as "pressure_out_of_range". A
// sensor that gives one value throughout for longer than the settings' limit is stuck: all is
// dropped and counted as "pressure_constant".
Stream<double> CheckPressure(const Stream<double>& pressure_hpa, const PressureSettings& settings,
                             std::map<std::string, std::int64_t>* counts);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_PRESSURE_H_
