#include "eval/study/study.h"

#include <algorithm>
#include <iterator>

#include "eval/files.h"

namespace walkgraph {
namespace {

bool ChangesPreparation(const ConfigOverride& item) {
  return item.key.rfind("frontend.", 0) == 0 || item.key.rfind("radio_map.", 0) == 0;
}

}  // namespace

std::vector<ConfigOverride> PreparationOverrides(const std::vector<ConfigOverride>& overrides) {
  std::vector<ConfigOverride> kept;
  std::copy_if(overrides.begin(), overrides.end(), std::back_inserter(kept), ChangesPreparation);
  return kept;
}

std::vector<ConfigOverride> EstimatorOverrides(const std::vector<ConfigOverride>& overrides) {
  std::vector<ConfigOverride> kept;
  std::remove_copy_if(overrides.begin(), overrides.end(), std::back_inserter(kept),
                      ChangesPreparation);
  return kept;
}

std::map<std::string, std::string> EffectiveOverrides(const std::vector<ConfigOverride>& base,
                                                      const std::vector<ConfigOverride>& cell) {
  std::map<std::string, std::string> values;
  for (const ConfigOverride& item : base) values[item.key] = item.text;
  for (const ConfigOverride& item : cell) values[item.key] = item.text;
  return values;
}

std::string ConfigurationHash(const Study& study, const StudyCell& cell) {
  std::string text = cell.method->name;
  for (const auto& [key, value] : EffectiveOverrides(study.base, cell.overrides)) {
    text.append("\n").append(key).append("=").append(value);
  }
  return TextChecksum(text);
}

}  // namespace walkgraph
