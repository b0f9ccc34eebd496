#ifndef WALKGRAPH_DATA_FORMATS_GETSENSORDATA_H_
#define WALKGRAPH_DATA_FORMATS_GETSENSORDATA_H_

#include <string>
#include <string_view>

#include "data/building.h"
#include "data/dataset.h"

// Logs of the Android application GetSensorData 2.x (LOPSI, CAR-CSIC), the format of the IPIN
// competitions. Every log documents its records in its header.

namespace walkgraph {

// Whether a file that begins like this is a GetSensorData log.
bool LooksLikeGetSensorData(std::string_view beginning);

// A recording, given the whole text. Truth is WGS84 with floors. Never throws on content.
//
// AppTimestamp is the clock of everything, but it jitters by tens of milliseconds: the application
// stamps a sample when it gets round to it. Intervals inside one sensor are exact in
// SensorTimestamp, so a sample's time is SensorTimestamp plus the median over that sensor of
// AppTimestamp minus SensorTimestamp. A sample more than half a second off that line keeps its
// AppTimestamp (hazard "sensor_clock_jump"). Wi-Fi rows are heard at their SensorTimestamp on the
// accelerometer's line. A BLE4 transmitter's name is its MAC address alone: identifiers are missing
// in some logs. GNSS, light, sound and other records are counted and not used.
Walk ReadGetSensorData(std::string_view text);

// Writes a log, the waypoints of `truth` in degrees (TruthFrame::kWgs84). Times are cut to tenths
// of a millisecond; of a beacon's name what follows the last '_' is its address. Throws InputError
// where the file cannot be written.
void WriteGetSensorData(const Recording& recording, const Truth& truth, const std::string& path);

// "Trial51" of "IPIN2023_T3_TrainingTrial51_repetition02"; the name itself where it has no such
// part.
std::string GetSensorDataTrial(const std::string& name);

// The building of a georeferencing file as the application's companion writes it (floorplans.cal:
// image names, floors, building numbers, centre latitudes and longitudes, rotations, metres per
// pixel; a column per floor). The building frame's origin is the centre of the first image, x runs
// along the image's columns. The file knows no heights: storeys are 3 m. Throws InputError.
Building ReadFloorplansCal(const std::string& path);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_FORMATS_GETSENSORDATA_H_
