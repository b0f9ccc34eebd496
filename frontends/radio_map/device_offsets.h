#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_DEVICE_OFFSETS_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_DEVICE_OFFSETS_H_

#include <string>
#include <vector>

#include "data/recording.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// By how much each survey walk hears everything louder than the survey's average: what its device
// and the way of holding it add to every reading of a radio.
struct DeviceOffsets {
  std::vector<double> offset_db;  // by SurveyScan::walk; 0 for who met nobody else's readings
  double spread_db = 0;           // standard deviation over walks
  double reading_sigma_db = 0;    // of a walk's mean reading of a transmitter in one square
};

// The random-effects model rssi = level of the transmitter in its square + offset of the walk +
// noise, on the mean readings of each walk in squares of `square_m`; levels are free, offsets
// normal. The ratio of both variances maximises the restricted likelihood, the offsets are the best
// linear unbiased predictions (Searle, Casella and McCulloch, Variance Components, chapter 7).
// Linear in the readings for the offsets; the variances take the eigenvectors of up to 1,000 walks.
DeviceOffsets EstimateDeviceOffsets(const std::vector<SurveyScan>& scans, Radio radio,
                                    double square_m);

// Sets the device_offset_db of all scans, radio by radio.
void SetDeviceOffsets(double square_m, std::vector<SurveyScan>* scans);

// What the offsets of the scans, once set, say of each phone model: their mean over its walks and
// the spread of one more walk, from the spread within models, which is taken to be the same in all.
// None of a radio whose walks were found to hear alike, or with fewer than three walks more than
// models. `device_of_walk` by SurveyScan::walk.
std::vector<DeviceLoudness> SummariseDevices(const std::vector<SurveyScan>& scans,
                                             const std::vector<std::string>& device_of_walk);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_DEVICE_OFFSETS_H_
