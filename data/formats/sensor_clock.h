#ifndef WALKGRAPH_DATA_FORMATS_SENSOR_CLOCK_H_
#define WALKGRAPH_DATA_FORMATS_SENSOR_CLOCK_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "data/read_report.h"
#include "data/time.h"

namespace walkgraph {

// Two stamps of each sample of one sensor: when the application wrote it (late by a random delay)
// and when the sensor says that it was taken (exact intervals, another origin).
struct TwoClocks {
  std::vector<TimeNs> application_ns;
  std::vector<TimeNs> sensor_ns;

  void push_back(TimeNs application, TimeNs sensor) {
    application_ns.push_back(application);
    sensor_ns.push_back(sensor);
  }
};

// The median of application minus sensor time; nullopt without samples.
std::optional<TimeNs> ClockOffset(const TwoClocks& clocks);

// Sample times on the application's clock with the sensor's intervals. A sample whose stamps differ
// from the offset by more than half a second keeps the application's (hazard "sensor_clock_jump").
std::vector<TimeNs> AlignToApplication(const TwoClocks& clocks, ReadReport* report);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_FORMATS_SENSOR_CLOCK_H_
