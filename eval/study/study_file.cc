#include "eval/study/study_file.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <set>

#include "data/input_error.h"
#include "eval/study/factor_design.h"
#include "eval/suggest.h"
#include "eval/usage_error.h"

namespace walkgraph {
namespace {

constexpr std::size_t kMaxCells = 100000;

int LineOf(const YAML::Node& node) { return node.Mark().line + 1; }

class StudyReader {
 public:
  StudyReader(std::string path, const std::vector<ConfigOverride>& overrides)
      : path_(std::move(path)), overrides_(overrides) {}

  Study Read(const YAML::Node& root) {
    RequireKeys(root, {"datasets", "split", "folds", "floor", "set", "methods", "factors", "grids",
                       "reference"});
    ReadDatasets(root["datasets"]);
    ReadSplit(root);
    ReadBase(root["set"]);
    for (const std::string& name : Words(root["methods"])) {
      study_.cells.push_back({name, MethodNamed(name, root["methods"]), {}});
    }
    if (root["factors"]) ReadFactors(root["factors"]);
    for (const YAML::Node& grid : root["grids"]) ReadGrid(grid);
    if (root["reference"]) study_.reference = Scalar(root["reference"], "the name of a cell");
    if (study_.reference.empty() && !study_.cells.empty()) {
      study_.reference = study_.cells.front().name;
    }
    return std::move(study_);
  }

 private:
  [[noreturn]] void Fail(const YAML::Node& node, const std::string& what,
                         const std::string& expected) const {
    throw InputError(path_, LineOf(node), what, expected);
  }

  void RequireKeys(const YAML::Node& map, const std::vector<std::string>& known) const {
    if (!map.IsMap()) Fail(map, "not a group of keys", "some of " + Joined(known));
    std::set<std::string> seen;
    for (const auto& entry : map) {
      const auto key = entry.first.as<std::string>();
      if (std::find(known.begin(), known.end(), key) == known.end()) {
        Fail(entry.first, "unknown key \"" + key + "\"" + DidYouMean(key, known),
             "one of " + Joined(known));
      }
      if (!seen.insert(key).second) Fail(entry.first, key + " is given twice", "it once");
    }
  }

  static std::string Joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
  }

  std::string Scalar(const YAML::Node& node, const std::string& expected) const {
    if (!node.IsScalar()) Fail(node, "not a single value", expected);
    return node.Scalar();
  }

  // A list of single values, or one alone; none where the key is missing.
  std::vector<std::string> Words(const YAML::Node& node) const {
    if (!node) return {};
    if (node.IsScalar()) return {node.Scalar()};
    if (!node.IsSequence()) Fail(node, "not a list", "a list of single values");
    std::vector<std::string> words;
    for (const YAML::Node& item : node) words.push_back(Scalar(item, "a list of single values"));
    return words;
  }

  void ReadDatasets(const YAML::Node& node) {
    if (!node) throw InputError(path_, 0, "no datasets", "`datasets:` with a folder or several");
    if (node.IsMap()) {
      for (const auto& entry : node) {
        study_.datasets.push_back(
            {entry.first.as<std::string>(), Scalar(entry.second, "a folder")});
      }
      return;
    }
    for (const std::string& path : Words(node)) {
      study_.datasets.push_back({DatasetNameOf(path), path});
    }
  }

  void ReadSplit(const YAML::Node& root) {
    if (const YAML::Node node = root["split"]) {
      study_.split_name = Scalar(node, "a kind of split");
      const auto split = SplitByName(study_.split_name);
      if (!split) {
        Fail(node, "split is \"" + study_.split_name + "\"",
             "walk, session, trial, phone or block");
      }
      study_.split = *split;
    }
    if (const YAML::Node node = root["folds"]) {
      try {
        study_.folds = node.as<int>();
      } catch (const YAML::Exception&) {
        study_.folds = 0;
      }
      if (study_.folds < 2) Fail(node, "folds is not a number of at least 2", "such a number");
    }
    if (const YAML::Node node = root["floor"]) {
      const std::string floor = Scalar(node, "given or unknown");
      if (floor != "given" && floor != "unknown") {
        Fail(node, "floor is \"" + floor + "\"", "given or unknown");
      }
      study_.floor_given = floor == "given";
    }
  }

  ConfigOverride Override(const YAML::Node& node, const std::string& key,
                          const std::string& value) const {
    try {
      ConfigOverride result = ParseSetFlag(key + "=" + value);
      result.place = path_ + ":" + std::to_string(LineOf(node));
      return result;
    } catch (const UsageError& error) {
      Fail(node, error.what(), "a key that `walkgraph config` lists and a value of its kind");
    }
  }

  void ReadBase(const YAML::Node& node) {
    if (node && !node.IsMap()) Fail(node, "not a group of keys", "KEY: VALUE");
    for (const auto& entry : node) {
      study_.base.push_back(Override(entry.first, entry.first.as<std::string>(),
                                     Scalar(entry.second, "a single value")));
    }
    study_.base.insert(study_.base.end(), overrides_.begin(), overrides_.end());
  }

  const Method* MethodNamed(const std::string& name, const YAML::Node& node) const {
    try {
      const std::vector<const Method*> methods = ParseMethods(name);
      if (methods.size() == 1) return methods.front();
    } catch (const UsageError& error) {
      Fail(node, error.what(), "a method that `walkgraph methods` lists");
    }
    Fail(node, "several methods", "one");
  }

  void ReadFactors(const YAML::Node& node) {
    RequireKeys(node, {"method", "design", "list"});
    const std::string method = node["method"] ? Scalar(node["method"], "a method") : "batch";
    const YAML::Node design_node = node["design"];
    const std::string design = design_node ? Scalar(design_node, "a design") : "all-subsets";
    try {
      if (design != "all-subsets" && design != "leave-one-out" && design != "add-one-in") {
        throw UsageError("design is \"" + design + "\"");
      }
      FactorStudy factors = ParseFactorStudy(design);
      if (node["list"]) factors.factors = Words(node["list"]);
      CheckFactors(factors.factors);
      AddFactorCells(factors, *MethodNamed(method, node), &study_);
    } catch (const UsageError& error) {
      Fail(node, error.what(), "all-subsets, leave-one-out or add-one-in of known factors");
    }
  }

  // All combinations of the keys' values, the last key's changing fastest.
  void ReadGrid(const YAML::Node& node) {
    RequireKeys(node, {"method", "keys"});
    if (!node["method"] || !node["keys"] || !node["keys"].IsMap()) {
      Fail(node, "a grid lacks its method or its keys",
           "`method: NAME` and `keys: {KEY: [VALUE]}`");
    }
    const Method* method = MethodNamed(Scalar(node["method"], "a method"), node["method"]);
    std::vector<StudyCell> cells = {{"", method, {}}};
    for (const auto& entry : node["keys"]) {
      const auto key = entry.first.as<std::string>();
      std::vector<StudyCell> wider;
      for (const StudyCell& cell : cells) {
        for (const std::string& value : Words(entry.second)) {
          wider.push_back(cell);
          wider.back().name.append(cell.name.empty() ? "" : " ").append(key).append("=" + value);
          wider.back().overrides.push_back(Override(entry.first, key, value));
        }
      }
      cells = std::move(wider);
      if (cells.size() > kMaxCells) Fail(node, "too many combinations", "at most 100,000");
    }
    for (StudyCell& cell : cells) {
      cell.name = method->name + "[" + cell.name + "]";
      study_.cells.push_back(std::move(cell));
    }
  }

  std::string path_;
  const std::vector<ConfigOverride>& overrides_;
  Study study_;
};

bool IsFolderName(const std::string& name) {
  return !name.empty() && name.front() != '.' &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
         });
}

}  // namespace

std::string DatasetNameOf(const std::string& path) {
  const std::filesystem::path whole =
      std::filesystem::absolute(std::filesystem::path(path)).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

Study ReadStudyFile(const std::string& path, const std::vector<ConfigOverride>& overrides) {
  YAML::Node root;
  try {
    root = YAML::LoadFile(path);
  } catch (const YAML::BadFile&) {
    throw InputError(path, 0, "cannot be read", "a YAML study");
  } catch (const YAML::Exception& error) {
    throw InputError(path, error.mark.line + 1, error.msg, "YAML");
  }
  Study study = StudyReader(path, overrides).Read(root);
  CheckStudy(study);
  return study;
}

void CheckStudy(const Study& study) {
  if (study.datasets.empty()) throw UsageError("the study has no data set");
  if (study.cells.empty()) throw UsageError("the study has no methods, factors or grids");
  std::set<std::string> datasets, cells;
  for (const StudyDataset& dataset : study.datasets) {
    if (!IsFolderName(dataset.name)) {
      throw UsageError("data set \"" + dataset.name +
                       "\": expected a name of letters, digits, '_', '-' and '.'");
    }
    if (!datasets.insert(dataset.name).second) {
      throw UsageError("two data sets are called " + dataset.name + ", expected names that differ");
    }
  }
  for (const StudyCell& cell : study.cells) {
    if (!cells.insert(cell.name).second) {
      throw UsageError("cell " + cell.name + " is in the study twice");
    }
  }
  if (!cells.contains(study.reference)) {
    throw UsageError("reference \"" + study.reference + "\"" +
                     DidYouMean(study.reference, {cells.begin(), cells.end()}) +
                     ": expected one of the study's cells");
  }
}

}  // namespace walkgraph
