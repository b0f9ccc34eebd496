#include "data/dataset.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "data/formats/csv.h"
#include "data/formats/getsensordata.h"
#include "data/formats/ilc20.h"
#include "data/formats/swiblux.h"
#include "data/formats/text_input.h"
#include "data/input_error.h"

namespace walkgraph {
namespace {

namespace fs = std::filesystem;

constexpr char kBuildingFile[] = "building.json";
constexpr char kFloorplansFile[] = "floorplans.cal";
constexpr char kKnownFormats[] =
    "an ilc20 or GetSensorData text file, a folder of CSV files, or a swiblux file";

// Enough for the longest known header (GetSensorData, 5 KB) and the first records behind it.
constexpr std::size_t kBeginningBytes = 16 * 1024;

// The name of the format of a file or folder, empty where none fits.
std::string RecogniseFormat(const fs::path& path) {
  if (fs::is_directory(path)) return IsCsvWalk(path.string()) ? "csv" : "";
  const std::string beginning = ReadFileBeginning(path.string(), kBeginningBytes);
  if (LooksLikeIlc20(beginning)) return "ilc20";
  if (LooksLikeGetSensorData(beginning)) return "getsensordata";
  if (LooksLikeSwiblux(beginning)) return "swiblux";
  return "";
}

// The path without a trailing slash, so that it has a name.
fs::path Named(const std::string& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

// `path` without extension relative to `root`, '/' as "__"; the name of the root itself for itself.
std::string WalkId(const fs::path& path, const fs::path& root) {
  if (path == root) return root.stem().string();
  const fs::path relative = path.lexically_relative(root);
  std::string id;
  for (const fs::path& part : relative.parent_path()) id += part.string() + "__";
  return id + (fs::is_directory(path) ? path.filename() : path.stem()).string();
}

// The floor folder that holds an ilc20 recording says on which floor it was walked.
std::optional<int> FloorFromLayout(const fs::path& recording) {
  const fs::path folder = fs::absolute(recording).lexically_normal().parent_path().parent_path();
  return Ilc20FloorNumber(folder.filename().string());
}

std::optional<WalkFile> FindWalk(const fs::path& path, const fs::path& root) {
  WalkFile walk;
  walk.path = path.string();
  walk.format = RecogniseFormat(path);
  if (walk.format.empty()) return std::nullopt;
  walk.id = WalkId(path, root);
  if (walk.format == "swiblux" && path != root) {  // all radios' folders make one recording
    walk.id = WalkId(path.parent_path().parent_path() / path.filename(), root);
  }
  walk.trial = walk.id;
  if (walk.format == "ilc20") walk.floor = FloorFromLayout(path);
  if (walk.format == "getsensordata") walk.trial = GetSensorDataTrial(walk.id);
  if (walk.format == "csv") {
    const std::string trial = ReadCsvTrial(walk.path);
    if (!trial.empty()) walk.trial = trial;
  }
  return walk;
}

// Whether a file in a data set may be a recording of its own.
bool MayBeRecording(const fs::directory_entry& entry) {
  if (entry.is_directory()) return true;
  if (!entry.is_regular_file()) return false;
  const fs::path extension = entry.path().extension();
  return extension == ".txt" ||
         (extension == ".csv" && StandsForSwibluxRecording(entry.path().string()));
}

void FindWalks(const fs::path& root, Dataset* dataset) {
  if (auto walk = FindWalk(root, root)) dataset->walks.push_back(*std::move(walk));
  if (!fs::is_directory(root)) return;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
    if (!MayBeRecording(entry)) continue;
    if (auto walk = FindWalk(entry.path(), root)) {
      dataset->walks.push_back(*std::move(walk));
    } else if (!entry.is_directory()) {
      dataset->unrecognised.push_back(entry.path().string());
    }
  }
  std::sort(dataset->walks.begin(), dataset->walks.end(),
            [](const WalkFile& a, const WalkFile& b) { return a.id < b.id; });
  std::sort(dataset->unrecognised.begin(), dataset->unrecognised.end());
}

// The floors of the site below `folder`; none where it is no site.
std::vector<Floor> ReadIlc20Site(const fs::path& folder) {
  std::vector<Floor> floors;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_directory() && IsIlc20Floor(entry.path().string())) {
      floors.push_back(ReadIlc20Floor(entry.path().string()));
    }
  }
  std::sort(floors.begin(), floors.end(),
            [](const Floor& a, const Floor& b) { return a.number < b.number; });
  return floors;
}

// What the nearest folder, from the dataset upwards, knows about the building; a description in
// walkgraph's own format comes first. Without any the building has no floors.
Building FindBuilding(const fs::path& root) {
  Building building;
  for (const fs::path& folder : {root, root.parent_path()}) {
    if (fs::is_regular_file(folder / kBuildingFile)) {
      building = ReadBuildingJson((folder / kBuildingFile).string());
    } else if (fs::is_regular_file(folder / kFloorplansFile)) {
      building = ReadFloorplansCal((folder / kFloorplansFile).string());
    } else if (IsIlc20Floor(folder.string())) {
      building.floors = {ReadIlc20Floor(folder.string())};
    } else if (IsSwibluxSet(folder.string())) {
      building.floors = {ReadSwibluxRoom(folder.string())};
    } else if (folder == root) {
      building.floors = ReadIlc20Site(folder);
    }
    if (!building.floors.empty()) {
      if (building.name.empty()) building.name = folder.filename().string();
      return building;
    }
  }
  building.name = root.filename().string();
  return building;
}

}  // namespace

Dataset OpenDataset(const std::string& path) {
  if (!fs::exists(path)) {
    throw InputError(path, 0, "no such file or folder", "recorded walks");
  }
  Dataset dataset;
  dataset.path = path;
  const fs::path root = Named(path);
  try {
    FindWalks(root, &dataset);
  } catch (const fs::filesystem_error& error) {
    throw InputError(path, 0, error.what(), "a folder that can be listed");
  }
  if (dataset.walks.empty()) throw InputError(path, 0, "no recording found", kKnownFormats);
  dataset.building = FindBuilding(fs::is_directory(root) ? root : root.parent_path());
  return dataset;
}

WalkFile IdentifyWalk(const std::string& path) {
  if (!fs::exists(path)) throw InputError(path, 0, "no such file or folder", "a recording");
  const fs::path named = Named(path);
  auto walk = FindWalk(named, named);
  if (!walk) throw InputError(path, 0, "no recording of a known format", kKnownFormats);
  walk->path = path;
  return *std::move(walk);
}

Walk ReadWalk(const WalkFile& file, const ReaderSettings& settings) {
  Walk walk;
  if (file.format == "ilc20") {
    walk = ReadIlc20(ReadFileBytes(file.path), file.floor);
  } else if (file.format == "getsensordata") {
    walk = ReadGetSensorData(ReadFileBytes(file.path));
  } else if (file.format == "csv") {
    walk = ReadCsvWalk(file.path);
  } else if (file.format == "swiblux") {
    walk = ReadSwiblux(file.path, settings);
  } else {
    throw InputError(file.path, 0, "unknown format '" + file.format + "'", kKnownFormats);
  }
  walk.recording.id = file.id;
  return walk;
}

}  // namespace walkgraph
