#ifndef WALKGRAPH_DATA_FORMATS_SWIBLUX_H_
#define WALKGRAPH_DATA_FORMATS_SWIBLUX_H_

#include <string>
#include <string_view>

#include "data/building.h"
#include "data/dataset.h"
#include "data/reader_settings.h"

// Fingerprints of three radios at fixed anchors in one room (Belmonte-Hernandez et al., IEEE
// Sensors Journal 19, 2019). A set holds a folder per radio (WIFI, BLE, Zigbee), each with
// Database.csv, the mean RSSI of each anchor per cell, and Test.csv, one reading per position of a
// route: rows "x;y;RSSI A;RSSI B;...". Limits.csv gives the room. There are no times and no other
// sensors.

namespace walkgraph {

// Whether a file that begins like this holds such rows.
bool LooksLikeSwiblux(std::string_view beginning);

// The files of the same name in the folders of all radios make one recording; the first of them
// that exists stands for it in a data set.
bool StandsForSwibluxRecording(const std::string& path);

// The recording that `path` is part of: row i of every radio is heard at second i (of the test, at
// second 1,000,000 + i), where the person is at the position of the row. Rows whose position
// differs from the first radio's by more than a centimetre are counted as "position_disagreement"
// and stay with the first's. Throws InputError where a file has a header of another kind.
Walk ReadSwiblux(const std::string& path, const ReaderSettings& settings);

// Whether a folder is such a set.
bool IsSwibluxSet(const std::string& folder);

// The room: floor 0, a rectangle. Throws InputError where Limits.csv holds anything but four
// increasing pairs of numbers (x from, to; y from, to).
Floor ReadSwibluxRoom(const std::string& folder);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_FORMATS_SWIBLUX_H_
