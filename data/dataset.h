#ifndef WALKGRAPH_DATA_DATASET_H_
#define WALKGRAPH_DATA_DATASET_H_

#include <optional>
#include <string>
#include <vector>

#include "data/building.h"
#include "data/read_report.h"
#include "data/reader_settings.h"
#include "data/recording.h"
#include "data/truth.h"

namespace walkgraph {

// A walk as read: what was recorded, what is true (no waypoints where nobody surveyed), and what
// the reader met on the way.
struct Walk {
  Recording recording;
  Truth truth;
  ReadReport report;
};

// A walk that has been found but not read.
struct WalkFile {
  std::string path;
  std::string format;        // "ilc20", "getsensordata", "csv", "swiblux"
  std::string id;            // path relative to the dataset, without extension, '/' as "__"
  std::string trial;         // group of the split by trial; the id where the format has no trials
  std::optional<int> floor;  // known from the layout (an ilc20 floor folder)
};

// A folder of walks in any supported format, recognised by content, or one walk.
struct Dataset {
  std::string path;
  Building building;
  std::vector<WalkFile> walks;            // by id
  std::vector<std::string> unrecognised;  // text files that are no recording of a known format
};

// Finds the walks and the building under `path` (for ilc20 a site or one of its floors), or the one
// recording at `path` and the building around it. Throws InputError where the path is missing or
// holds no walk of a known format.
Dataset OpenDataset(const std::string& path);

// Recognises one recording by looking at it; id and trial from its file name.
// Throws InputError where the file is missing or of no known format.
WalkFile IdentifyWalk(const std::string& path);

// Reads a recording of any supported format. Broken lines are counted, not thrown; throws
// InputError where the file cannot be read at all or is of no known format.
Walk ReadWalk(const WalkFile& file, const ReaderSettings& settings = {});

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_DATASET_H_
