#include "eval/study/factor_design.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "eval/split.h"
#include "eval/suggest.h"
#include "eval/usage_error.h"

namespace walkgraph {
namespace {

constexpr std::size_t kMaxFactors = 16;  // 65,536 subsets

struct Switch {
  std::string_view factor;
  std::string_view off;  // the assignments that take it out
};

constexpr std::array<Switch, 17> kSwitches = {{
    {"step", "factors.step.enabled=false"},
    {"heading_increment", "factors.heading_increment.enabled=false"},
    {"absolute_heading", "factors.absolute_heading.enabled=false"},
    {"standing", "factors.standing.enabled=false"},
    {"fingerprint",
     "factors.fingerprint.wifi=false factors.fingerprint.beacon=false "
     "factors.fingerprint.zigbee=false"},
    {"wifi", "factors.fingerprint.wifi=false"},
    {"beacon", "factors.fingerprint.beacon=false"},
    {"zigbee", "factors.fingerprint.zigbee=false"},
    {"magnetic", "factors.magnetic.enabled=false"},
    {"area", "factors.area.kind=none"},
    {"barometric", "factors.barometric.enabled=false"},
    {"gyro_bias", "factors.gyro_bias.mode=absent"},
    {"heading_offset", "factors.heading_offset.mode=absent"},
    {"step_scale", "factors.step_scale.mode=absent"},
    {"map_error", "factors.map_error.mode=absent"},
    {"rssi_offset", "factors.rssi_offset.mode=absent"},
    {"barometric_offset", "factors.barometric_offset.mode=absent"},
}};

// Precondition: a factor that CheckFactors knows.
std::vector<ConfigOverride> SwitchedOff(const std::string& factor) {
  const auto* found = std::find_if(kSwitches.begin(), kSwitches.end(),
                                   [&](const Switch& s) { return s.factor == factor; });
  std::vector<ConfigOverride> overrides;
  for (const std::string_view assignment : Split(found->off, ' ')) {
    overrides.push_back(ParseSetFlag(std::string(assignment)));
  }
  return overrides;
}

bool IsOff(const Settings& settings, const std::vector<ConfigOverride>& off) {
  Settings changed = settings;
  ApplyOverrides(off, &changed);
  return ChangedValues(settings, changed).empty();
}

std::vector<std::uint32_t> SubsetsOf(const FactorStudy& study) {
  const std::size_t n = study.factors.size();
  const std::uint32_t all = (std::uint32_t{1} << n) - 1;
  std::vector<std::uint32_t> subsets;
  if (study.design == FactorDesign::kAllSubsets) {
    for (std::uint32_t s = 0; s <= all; ++s) subsets.push_back(s);
    return subsets;
  }
  const bool leave = study.design == FactorDesign::kLeaveOneOut;
  if (!leave) subsets.push_back(0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t bit = std::uint32_t{1} << i;
    subsets.push_back(leave ? all & ~bit : bit);
  }
  subsets.push_back(all);
  // With one factor a subset can come from both rules.
  std::sort(subsets.begin(), subsets.end());
  subsets.erase(std::unique(subsets.begin(), subsets.end()), subsets.end());
  return subsets;
}

std::string SubsetName(const std::vector<std::string>& factors, std::uint32_t subset) {
  if (subset == 0) return "none";
  const std::size_t missing = factors.size() - static_cast<std::size_t>(std::popcount(subset));
  const bool by_missing = missing <= 2 && 2 * missing < factors.size();
  std::string name = by_missing ? "all" : "";
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const bool member = (subset >> i & 1) != 0;
    if (by_missing && !member) name += "-" + factors[i];
    if (!by_missing && member) name += (name.empty() ? "" : "+") + factors[i];
  }
  return name;
}

}  // namespace

std::vector<std::string> SwitchableFactors() {
  std::vector<std::string> names;
  names.reserve(kSwitches.size());
  for (const Switch& s : kSwitches) names.emplace_back(s.factor);
  return names;
}

std::vector<std::string> DefaultFactors() {
  return {"step",           "heading_increment", "absolute_heading", "fingerprint",
          "heading_offset", "step_scale",        "map_error"};
}

FactorStudy ParseFactorStudy(std::string_view text) {
  if (text == "all-subsets") return {FactorDesign::kAllSubsets, DefaultFactors()};
  if (text == "leave-one-out") return {FactorDesign::kLeaveOneOut, DefaultFactors()};
  if (text == "add-one-in") return {FactorDesign::kAddOneIn, DefaultFactors()};
  FactorStudy study;
  for (const std::string_view factor : Split(text, ',')) study.factors.emplace_back(factor);
  CheckFactors(study.factors);
  return study;
}

void CheckFactors(const std::vector<std::string>& factors) {
  const std::vector<std::string> known = SwitchableFactors();
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (std::find(known.begin(), known.end(), factors[i]) == known.end()) {
      std::string all;
      for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
      throw UsageError("unknown factor \"" + factors[i] + "\"" + DidYouMean(factors[i], known) +
                       ", expected all-subsets, leave-one-out, add-one-in or some of " + all);
    }
    if (std::count(factors.begin(), factors.end(), factors[i]) > 1) {
      throw UsageError("factor " + factors[i] + " is given twice, expected once");
    }
  }
  if (factors.empty() || factors.size() > kMaxFactors) {
    throw UsageError(std::to_string(factors.size()) + " factors, expected 1 to 16");
  }
}

void AddFactorCells(const FactorStudy& factors, const Method& method, Study* study) {
  Settings base;
  ApplyOverrides(study->base, &base);
  for (const std::string& factor : factors.factors) {
    if (!IsOff(base, SwitchedOff(factor))) continue;
    throw UsageError("factor " + factor + " is listed, but switched off for the whole study");
  }
  study->factors = factors.factors;
  for (const std::uint32_t subset : SubsetsOf(factors)) {
    StudyCell cell{method.name + ":" + SubsetName(factors.factors, subset), &method, {}};
    for (std::size_t i = 0; i < factors.factors.size(); ++i) {
      if ((subset >> i & 1) != 0) continue;
      const std::vector<ConfigOverride> off = SwitchedOff(factors.factors[i]);
      cell.overrides.insert(cell.overrides.end(), off.begin(), off.end());
    }
    study->cell_of_subset[subset] = study->cells.size();
    study->cells.push_back(std::move(cell));
  }
  study->reference = study->cells.back().name;
}

}  // namespace walkgraph
