#include "eval/study/study_folder.h"

#include <glog/logging.h>

#include <cstddef>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "data/input_error.h"
#include "eval/files.h"
#include "eval/version.h"

namespace walkgraph {
namespace {

using Json = nlohmann::ordered_json;

std::optional<std::string> ReadIfThere(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

StudyRecord FromJson(const Json& json) {
  StudyRecord record;
  record.version = json.at("version").get<std::string>();
  record.split = json.at("split").get<std::string>();
  record.folds = json.at("folds").get<int>();
  record.floor_given = json.at("floor_given").get<bool>();
  record.base = json.at("base").get<std::map<std::string, std::string>>();
  for (const Json& item : json.at("datasets")) {
    record.datasets.push_back({item.at("name").get<std::string>(),
                               item.at("checksums").get<std::map<std::string, std::string>>()});
  }
  for (const Json& item : json.at("cells")) {
    record.cells.push_back(
        {item.at("name").get<std::string>(), item.at("method").get<std::string>(),
         item.at("overrides").get<std::map<std::string, std::string>>(),
         item.at("configuration").get<std::string>(), item.at("part").get<std::string>()});
  }
  record.reference = json.at("reference").get<std::string>();
  record.factors = json.at("factors").get<std::vector<std::string>>();
  for (const Json& pair : json.at("subsets")) {
    record.cell_of_subset[pair.at(0).get<std::uint32_t>()] = pair.at(1).get<std::size_t>();
  }
  return record;
}

template <typename Value>
std::string Differs(const char* what, const Value& ours, const Value& theirs) {
  if (ours == theirs) return "";
  if constexpr (std::is_same_v<Value, std::string>) {
    return std::string(what) + " " + theirs + " instead of " + ours;
  } else {
    return std::string(what) + " " + std::to_string(theirs) + " instead of " + std::to_string(ours);
  }
}

// The first key at which two maps differ.
std::string MapDifference(const char* what, const std::map<std::string, std::string>& ours,
                          const std::map<std::string, std::string>& theirs) {
  std::string text = what;
  text += " ";
  for (const auto& [key, value] : ours) {
    const auto found = theirs.find(key);
    if (found == theirs.end()) return text.append(key).append(" missing");
    if (found->second != value) {
      return text.append(key)
          .append(" is ")
          .append(found->second)
          .append(" instead of ")
          .append(value);
    }
  }
  for (const auto& [key, value] : theirs) {
    if (!ours.contains(key)) return text.append(key).append(" too many");
  }
  return "";
}

std::string DatasetDifference(const StudyRecord& record, const StudyRecord& other) {
  std::string difference =
      Differs("number of data sets", record.datasets.size(), other.datasets.size());
  for (std::size_t i = 0; difference.empty() && i < record.datasets.size(); ++i) {
    difference = Differs("data set", record.datasets[i].name, other.datasets[i].name);
    if (!difference.empty()) break;
    difference = MapDifference("checksum of walk", record.datasets[i].checksums,
                               other.datasets[i].checksums);
  }
  return difference;
}

}  // namespace

std::string PartName(const std::vector<ConfigOverride>& preparation) {
  std::string name;
  for (const auto& [key, value] : EffectiveOverrides({}, preparation)) {
    name.append(name.empty() ? "" : "+").append(key).append("=").append(value);
  }
  return name.empty() ? "base" : name;
}

StudyRecord MakeStudyRecord(const Study& study) {
  StudyRecord record;
  record.version = Version();
  record.split = study.split_name;
  record.folds = study.folds;
  record.floor_given = study.floor_given;
  record.base = EffectiveOverrides(study.base, {});
  for (const StudyDataset& dataset : study.datasets) record.datasets.push_back({dataset.name, {}});
  for (const StudyCell& cell : study.cells) {
    record.cells.push_back({cell.name, cell.method->name, EffectiveOverrides({}, cell.overrides),
                            ConfigurationHash(study, cell),
                            PartName(PreparationOverrides(cell.overrides))});
  }
  record.reference = study.reference;
  record.factors = study.factors;
  record.cell_of_subset = study.cell_of_subset;
  return record;
}

std::string FormatStudyRecord(const StudyRecord& record) {
  Json json = {{"version", record.version}, {"split", record.split},
               {"folds", record.folds},     {"floor_given", record.floor_given},
               {"base", record.base},       {"datasets", Json::array()},
               {"cells", Json::array()},    {"reference", record.reference},
               {"factors", record.factors}, {"subsets", Json::array()}};
  for (const StudyDatasetRecord& dataset : record.datasets) {
    json["datasets"].push_back({{"name", dataset.name}, {"checksums", dataset.checksums}});
  }
  for (const StudyCellRecord& cell : record.cells) {
    json["cells"].push_back({{"name", cell.name},
                             {"method", cell.method},
                             {"overrides", cell.overrides},
                             {"configuration", cell.configuration},
                             {"part", cell.part}});
  }
  for (const auto& [subset, cell] : record.cell_of_subset) {
    json["subsets"].push_back(Json::array({subset, cell}));
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<StudyRecord> ReadStudyRecord(const std::string& dir) {
  const std::string path = dir + "/study.json";
  const std::optional<std::string> text = ReadIfThere(path);
  if (!text) return std::nullopt;
  try {
    return FromJson(Json::parse(*text));
  } catch (const Json::exception& error) {
    throw InputError(path, 0, error.what(), "the record of a study");
  }
}

std::string DifferenceOfInputs(const StudyRecord& record, const StudyRecord& other) {
  std::string difference = Differs("version", record.version, other.version);
  if (difference.empty()) difference = Differs("split", record.split, other.split);
  if (difference.empty()) difference = Differs("folds", record.folds, other.folds);
  if (difference.empty() && record.floor_given != other.floor_given) {
    difference =
        other.floor_given ? "floor given instead of unknown" : "floor unknown instead of given";
  }
  if (difference.empty()) difference = MapDifference("setting", record.base, other.base);
  if (difference.empty()) difference = DatasetDifference(record, other);
  return difference;
}

std::size_t ReferenceCell(const StudyRecord& record) {
  for (std::size_t c = 0; c < record.cells.size(); ++c) {
    if (record.cells[c].name == record.reference) return c;
  }
  return 0;
}

std::string WalkCellsPath(const std::string& dir, const std::string& dataset,
                          const std::string& part, const std::string& walk) {
  return dir + "/cells/" + dataset + "/" + part + "/" + walk + ".json";
}

std::optional<WalkCells> ReadWalkCells(const std::string& path) {
  const std::optional<std::string> text = ReadIfThere(path);
  if (!text) return std::nullopt;
  std::optional<WalkCells> walk = ParseWalkCells(*text);
  if (!walk) LOG(WARNING) << path << ": damaged, its results are computed again";
  return walk;
}

std::optional<WalkCells> SelectCells(const WalkCells& walk,
                                     const std::vector<const StudyCellRecord*>& cells) {
  WalkCells selected = walk;
  selected.cells.clear();
  for (const StudyCellRecord* cell : cells) {
    const CellResult* found = FindCell(walk, cell->name, cell->configuration);
    if (found == nullptr) return std::nullopt;
    selected.cells.push_back(*found);
  }
  return selected;
}

}  // namespace walkgraph
