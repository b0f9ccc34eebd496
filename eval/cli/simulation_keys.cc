#include "simulation_keys.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>

#include "data/simulator/settings_visit.h"
#include "eval/suggest.h"
#include "eval/usage_error.h"

namespace walkgraph {
namespace {

constexpr std::array<std::string_view, 4> kBarometerStates = {"works", "missing", "stops",
                                                              "constant"};
constexpr std::array<std::string_view, 3> kPressureUnits = {"hpa", "pa", "kpa"};

std::span<const std::string_view> EnumNames(BarometerState /*tag*/) { return kBarometerStates; }
std::span<const std::string_view> EnumNames(PressureUnit /*tag*/) { return kPressureUnits; }

// By the naming convention of the settings: levels, angles on Earth and floor numbers have a sign.
bool MayBeNegative(std::string_view name) {
  return name.ends_with("_dbm") || name.ends_with("_deg") || name == "lowest_floor";
}

// What the simulator divides by or cannot do without; spreads may always be zero.
bool MayBeZero(std::string_view name) {
  constexpr std::array<std::string_view, 17> kPositive = {
      "_hz",     "_k",         "length_m", "length_s", "spacing_m",  "height_m",
      "floors",  "duration_s", "wander_s", "_sweep_s", "interval_s", "tread_m",
      "riser_m", "_speed_mps", "_mps2",    "width_db", "weather_hpa"};
  if (name.find("sigma") != std::string_view::npos ||
      name.find("swing") != std::string_view::npos ||
      name.find("noise") != std::string_view::npos) {
    return true;
  }
  return std::none_of(kPositive.begin(), kPositive.end(),
                      [name](std::string_view ending) { return name.ends_with(ending); });
}

class KeyCollector {
 public:
  template <typename Value>
  void Field(const char* name, Value& value, const char* documentation) {
    ConfigKey key;
    key.name = group_ + "." + name;
    key.documentation = documentation;
    if constexpr (std::is_enum_v<Value>) {
      static_assert(sizeof(Value) == 1, "configured enumerations are bytes");
      key.target = EnumKey{reinterpret_cast<std::uint8_t*>(&value), EnumNames(value)};
    } else {
      key.target = &value;
      key.must_be_positive = !std::is_same_v<Value, bool> && !MayBeNegative(name);
      key.may_be_zero = MayBeZero(name);
    }
    keys_.push_back(std::move(key));
  }

  template <typename Struct>
  void Group(const char* name, Struct& group) {
    group_ = name;
    Visit(*this, group);
  }

  std::vector<ConfigKey> TakeKeys() { return std::move(keys_); }

 private:
  std::string group_;
  std::vector<ConfigKey> keys_;
};

}  // namespace

std::vector<ConfigKey> SimulationKeys(SimulationSettings* settings) {
  KeyCollector collector;
  Visit(collector, *settings);
  return collector.TakeKeys();
}

void AssignSimulationKey(const std::string& key, const std::string& value, const std::string& flag,
                         SimulationSettings* settings) {
  const std::vector<ConfigKey> keys = SimulationKeys(settings);
  const auto found = std::find_if(keys.begin(), keys.end(),
                                  [&key](const ConfigKey& known) { return known.name == key; });
  if (found == keys.end()) {
    std::vector<std::string> names;
    names.reserve(keys.size());
    for (const ConfigKey& known : keys) names.push_back(known.name);
    throw UsageError(flag + ": unknown key \"" + key + "\"" + DidYouMean(key, names) +
                     ", expected one that simulation.yaml of any simulation lists");
  }
  const std::string expected = AssignValue(*found, value);
  if (!expected.empty()) {
    throw UsageError(flag + ": " + key + " is " + value + ", expected " + expected);
  }
}

std::string PrintSimulationSettings(const SimulationSettings& settings) {
  constexpr std::size_t kDocumentationColumn = 44;
  SimulationSettings copy = settings;
  std::string text;
  std::string group;
  for (const ConfigKey& key : SimulationKeys(&copy)) {
    const std::size_t dot = key.name.find('.');
    if (key.name.substr(0, dot) != group) {
      group = key.name.substr(0, dot);
      text += group + ":\n";
    }
    std::string line = "  ";
    line.append(key.name.substr(dot + 1)).append(": ").append(FormatValue(key));
    line.resize(std::max(line.size() + 2, kDocumentationColumn), ' ');
    text.append(line).append("# ").append(key.documentation).append("\n");
  }
  return text;
}

}  // namespace walkgraph
