#include "data/dataset.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "data/formats/ilc20.h"
#include "data/formats/text_input.h"
#include "data/input_error.h"

namespace walkgraph {
namespace {

namespace fs = std::filesystem;

// Enough for the longest known header (GetSensorData, 5 KB) and the first records behind it.
constexpr std::size_t kBeginningBytes = 16 * 1024;

// The name of the format, empty where none fits.
std::string RecogniseFormat(const std::string& path) {
  const std::string beginning = ReadFileBeginning(path, kBeginningBytes);
  if (LooksLikeIlc20(beginning)) return "ilc20";
  return "";
}

std::string JoinedId(const fs::path& relative) {
  std::string id;
  for (const fs::path& part : relative.parent_path()) {
    if (part != ".") id += part.string() + "__";
  }
  return id + relative.stem().string();
}

// The floor folder that holds an ilc20 recording says on which floor it was walked.
std::optional<int> FloorFromLayout(const fs::path& recording) {
  const fs::path folder = fs::absolute(recording).lexically_normal().parent_path().parent_path();
  return Ilc20FloorNumber(folder.filename().string());
}

std::optional<WalkFile> FindWalk(const fs::path& path, const std::string& id) {
  WalkFile walk;
  walk.path = path.string();
  walk.format = RecogniseFormat(walk.path);
  walk.id = id;
  walk.trial = id;
  if (walk.format.empty()) return std::nullopt;
  walk.floor = FloorFromLayout(path);
  return walk;
}

std::vector<fs::path> FilesBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// The folder without a trailing slash, so that it has a name.
fs::path NamedFolder(const std::string& path) {
  fs::path folder = fs::absolute(path).lexically_normal();
  return folder.has_filename() ? folder : folder.parent_path();
}

// The floors of a site, of the floor itself, or of the floor around its path_data_files.
Building ReadIlc20Building(const fs::path& folder) {
  Building building;
  building.name = folder.filename().string();
  for (const fs::path& candidate : {folder, folder.parent_path()}) {
    if (!IsIlc20Floor(candidate.string())) continue;
    building.floors.push_back(ReadIlc20Floor(candidate.string()));
    return building;
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_directory() && IsIlc20Floor(entry.path().string())) {
      building.floors.push_back(ReadIlc20Floor(entry.path().string()));
    }
  }
  std::sort(building.floors.begin(), building.floors.end(),
            [](const Floor& a, const Floor& b) { return a.number < b.number; });
  return building;
}

}  // namespace

Dataset OpenDataset(const std::string& path) {
  if (!fs::is_directory(path)) {
    throw InputError(path, 0, "no such folder", "a folder with recorded walks");
  }
  Dataset dataset;
  dataset.path = path;
  const fs::path root = NamedFolder(path);
  for (const fs::path& file : FilesBelow(root)) {
    if (file.extension() != ".txt") continue;
    if (auto walk = FindWalk(file, JoinedId(file.lexically_relative(root)))) {
      dataset.walks.push_back(*std::move(walk));
    } else {
      dataset.unrecognised.push_back(file.string());
    }
  }
  if (dataset.walks.empty()) {
    throw InputError(path, 0, "no recording of a known format", "ilc20");
  }
  std::sort(dataset.walks.begin(), dataset.walks.end(),
            [](const WalkFile& a, const WalkFile& b) { return a.id < b.id; });
  dataset.building = ReadIlc20Building(root);
  return dataset;
}

WalkFile IdentifyWalk(const std::string& path) {
  if (!fs::exists(path)) throw InputError(path, 0, "no such file", "a recording");
  auto walk = FindWalk(path, fs::path(path).stem().string());
  if (!walk) throw InputError(path, 0, "not a recording of a known format", "ilc20");
  return *std::move(walk);
}

Walk ReadWalk(const WalkFile& file) {
  const std::string text = ReadFileBytes(file.path);
  if (file.format != "ilc20") {
    throw InputError(file.path, 0, "unknown format '" + file.format + "'", "ilc20");
  }
  Walk walk = ReadIlc20(text, file.floor);
  walk.recording.id = file.id;
  return walk;
}

}  // namespace walkgraph
