#include "eval/config.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <utility>

#include "data/input_error.h"
#include "eval/config_keys.h"
#include "eval/suggest.h"
#include "eval/usage_error.h"

namespace walkgraph {
namespace {

// What is wrong with an assignment, in the two halves of an InputError; empty where nothing is.
struct Complaint {
  std::string what;
  std::string expected;
};

std::vector<std::string> Names(const std::vector<ConfigKey>& keys) {
  std::vector<std::string> names;
  names.reserve(keys.size());
  for (const ConfigKey& key : keys) names.push_back(key.name);
  return names;
}

Complaint Assign(const std::vector<ConfigKey>& keys, const std::string& name,
                 const std::string& text) {
  const auto key = std::find_if(keys.begin(), keys.end(),
                                [&](const ConfigKey& candidate) { return candidate.name == name; });
  if (key == keys.end()) {
    return {"unknown key \"" + name + "\"" + DidYouMean(name, Names(keys)),
            "a key that `walkgraph config` lists"};
  }
  const std::string expected = AssignValue(*key, text);
  if (expected.empty()) return {};
  return {name + " is \"" + text + "\"", expected};
}

// Reads the leaves of a YAML tree into overrides.
class TreeReader {
 public:
  TreeReader(std::string path, std::vector<ConfigOverride>* overrides)
      : path_(std::move(path)), keys_(ConfigKeys(&scratch_)), overrides_(overrides) {}

  void Read(const YAML::Node& node, const std::string& prefix) {
    for (const auto& entry : node) {
      const int line = entry.first.Mark().line + 1;
      const std::string name = prefix + entry.first.as<std::string>();
      if (entry.second.IsMap()) {
        CheckGroup(name, line);
        Read(entry.second, name + ".");
      } else if (entry.second.IsScalar()) {
        ReadLeaf(name, entry.second.Scalar(), line);
      } else if (!entry.second.IsNull() || !IsGroup(name)) {  // a group may be left empty
        throw InputError(path_, line, name + " is not a value",
                         "a group of keys or a single value");
      }
    }
  }

 private:
  bool IsGroup(const std::string& name) const {
    return std::any_of(keys_.begin(), keys_.end(), [&](const ConfigKey& key) {
      return key.name.compare(0, name.size() + 1, name + ".") == 0;
    });
  }

  // Every prefix of a key, for the suggestion on a misspelt group.
  std::vector<std::string> Groups() const {
    std::vector<std::string> groups;
    for (const ConfigKey& key : keys_) {
      for (std::size_t dot = key.name.find('.'); dot != std::string::npos;
           dot = key.name.find('.', dot + 1)) {
        groups.push_back(key.name.substr(0, dot));
      }
    }
    return groups;
  }

  void CheckGroup(const std::string& name, int line) const {
    if (IsGroup(name)) return;
    throw InputError(path_, line, "unknown group \"" + name + "\"" + DidYouMean(name, Groups()),
                     "a group that `walkgraph config` lists");
  }

  void ReadLeaf(const std::string& name, const std::string& text, int line) {
    const Complaint complaint = Assign(keys_, name, text);
    if (!complaint.what.empty()) {
      throw InputError(path_, line, complaint.what, complaint.expected);
    }
    for (const ConfigOverride& earlier : *overrides_) {
      if (earlier.key == name) {
        throw InputError(path_, line, name + " is given twice", "it once, as at " + earlier.place);
      }
    }
    overrides_->push_back({name, text, path_ + ":" + std::to_string(line)});
  }

  std::string path_;
  Settings scratch_;  // takes the values while they are checked
  std::vector<ConfigKey> keys_;
  std::vector<ConfigOverride>* overrides_;
};

constexpr std::size_t kCommentColumn = 36;

std::vector<std::string> SplitAtDots(const std::string& name) {
  std::vector<std::string> parts;
  std::istringstream stream(name);
  for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
  return parts;
}

// The factors' numbers and switches are collected together but printed apart.
int RootRank(const std::string& name) {
  if (name.compare(0, 6, "noise.") == 0) return 0;
  if (name.compare(0, 8, "factors.") == 0) return 1;
  return 2;
}

std::string ReadWholeFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf())) {
    throw InputError(path, 0, "cannot be read", "a YAML configuration file");
  }
  return text.str();
}

// The keys as nested YAML with their documentation.
std::string PrintKeys(std::vector<ConfigKey> keys) {
  std::stable_sort(keys.begin(), keys.end(), [](const ConfigKey& a, const ConfigKey& b) {
    return RootRank(a.name) < RootRank(b.name);
  });
  std::string text;
  std::vector<std::string> open;  // groups that the last line stands in
  for (const ConfigKey& key : keys) {
    const std::vector<std::string> parts = SplitAtDots(key.name);
    std::size_t depth = 0;
    while (depth < open.size() && depth + 1 < parts.size() && open[depth] == parts[depth]) ++depth;
    for (; depth + 1 < parts.size(); ++depth) {
      text += std::string(2 * depth, ' ') + parts[depth] + ":\n";
    }
    open.assign(parts.begin(), parts.end() - 1);
    std::string line = std::string(2 * depth, ' ') + parts.back() + ": " + FormatValue(key);
    line.resize(std::max(line.size() + 2, kCommentColumn), ' ');
    text += line + "# " + key.documentation + "\n";
  }
  return text;
}

}  // namespace

std::vector<ConfigOverride> ReadConfigFile(const std::string& path) {
  std::vector<ConfigOverride> overrides;
  const std::string text = ReadWholeFile(path);
  YAML::Node root;
  try {
    root = YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw InputError(path, error.mark.line + 1, error.msg, "YAML");
  }
  if (root.IsNull()) return overrides;  // an empty file sets nothing
  if (!root.IsMap()) throw InputError(path, 1, "not a group of keys", "`noise:` and the like");
  TreeReader(path, &overrides).Read(root, "");
  return overrides;
}

ConfigOverride ParseSetFlag(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError("--set " + assignment + ": expected --set KEY=VALUE");
  }
  ConfigOverride result{assignment.substr(0, equals), assignment.substr(equals + 1), "--set"};
  Settings scratch;
  const Complaint complaint = Assign(ConfigKeys(&scratch), result.key, result.text);
  if (!complaint.what.empty()) {
    throw UsageError("--set " + assignment + ": " + complaint.what + ", expected " +
                     complaint.expected);
  }
  return result;
}

void ApplyOverrides(const std::vector<ConfigOverride>& overrides, Settings* settings) {
  const std::vector<ConfigKey> keys = ConfigKeys(settings);
  for (const ConfigOverride& item : overrides) Assign(keys, item.key, item.text);
}

std::map<std::string, std::string> ChangedValues(const Settings& base, const Settings& changed) {
  Settings a = base, b = changed;
  const std::vector<ConfigKey> before = ConfigKeys(&a), after = ConfigKeys(&b);
  std::map<std::string, std::string> changes;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const std::string value = FormatValue(after[i]);
    if (value != FormatValue(before[i])) changes[after[i].name] = value;
  }
  return changes;
}

std::string PrintConfig(const Settings& settings) {
  Settings copy = settings;
  return PrintKeys(ConfigKeys(&copy));
}

std::string PrintChanges(const Settings& base, const Settings& changed) {
  const std::map<std::string, std::string> changes = ChangedValues(base, changed);
  Settings copy = changed;
  std::vector<ConfigKey> keys = ConfigKeys(&copy);
  std::erase_if(keys, [&](const ConfigKey& key) { return !changes.contains(key.name); });
  return PrintKeys(std::move(keys));
}

}  // namespace walkgraph
