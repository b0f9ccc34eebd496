#include "eval/config_keys.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace walkgraph {
namespace {

constexpr std::array<std::string_view, 4> kLossNames = {"none", "huber", "cauchy", "truncated"};
constexpr std::array<std::string_view, 3> kStateModeNames = {"active", "fixed", "absent"};
constexpr std::array<std::string_view, 2> kSurveyPositionsNames = {"walked_distance", "smoother"};

std::span<const std::string_view> EnumNames(LossKind /*tag*/) { return kLossNames; }
std::span<const std::string_view> EnumNames(StateMode /*tag*/) { return kStateModeNames; }
std::span<const std::string_view> EnumNames(SurveyPositions /*tag*/) {
  return kSurveyPositionsNames;
}
std::span<const std::string_view> EnumNames(ReferenceArea /*tag*/) { return kReferenceAreaNames; }
std::span<const std::string_view> EnumNames(AreaKind /*tag*/) { return kAreaKindNames; }
std::span<const std::string_view> EnumNames(ErrorBlockMode /*tag*/) { return kErrorBlockModeNames; }
std::span<const std::string_view> EnumNames(MapInterpolation /*tag*/) {
  return kMapInterpolationNames;
}
std::span<const std::string_view> EnumNames(StoreRule /*tag*/) { return kStoreRuleNames; }
std::span<const std::string_view> EnumNames(HipeCase /*tag*/) { return kHipeCaseNames; }
std::span<const std::string_view> EnumNames(HipeDistance /*tag*/) { return kHipeDistanceNames; }

template <typename Value>
auto BindTarget(Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    static_assert(sizeof(Value) == 1, "configured enumerations are bytes");
    return EnumKey{reinterpret_cast<std::uint8_t*>(&value), EnumNames(value)};
  } else {
    return &value;
  }
}

bool EndsWith(std::string_view text, std::string_view ending) {
  return text.size() >= ending.size() && text.substr(text.size() - ending.size()) == ending;
}

// By the naming convention of the settings: these are what a residual or a time is divided by.
bool IsMagnitude(std::string_view name) {
  return name.find("sigma") != std::string_view::npos || name.find("walk_") == 0 ||
         name == "n_eff" || EndsWith(name, "_scale") || EndsWith(name, "_s");
}

// Collects the keys of a struct under a prefix.
class KeyCollector {
 public:
  // Numbers go under `number_root`, switches under `switch_root`.
  KeyCollector(std::string number_root, std::string switch_root, std::vector<ConfigKey>* keys)
      : number_root_(std::move(number_root)), switch_root_(std::move(switch_root)), keys_(keys) {}

  template <typename Value>
  void Field(const char* name, Value& value, const char* documentation) {
    constexpr bool kIsNumber = std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>;
    ConfigKey key;
    key.name = (kIsNumber ? number_root_ : switch_root_) + group_ + "." + name;
    key.documentation = documentation;
    key.target = BindTarget(value);
    if constexpr (kIsNumber) {
      key.must_be_positive = IsMagnitude(name);
      key.may_be_zero = !key.must_be_positive || value == Value{};
    }
    keys_->push_back(std::move(key));
  }

  template <typename Struct>
  void Group(const char* name, Struct& group) {
    const std::string outer = group_;
    group_ += std::string(".") + name;
    Visit(*this, group);
    group_ = outer;
  }

 private:
  std::string number_root_;
  std::string switch_root_;
  std::string group_;
  std::vector<ConfigKey>* keys_;
};

template <typename Struct>
void Collect(const char* root, Struct& group, std::vector<ConfigKey>* keys) {
  KeyCollector collector(root, root, keys);
  Visit(collector, group);
}

std::vector<ConfigKey> CollectKeys(Settings* settings) {
  std::vector<ConfigKey> keys;
  KeyCollector factors("noise", "factors", &keys);
  Visit(factors, settings->factors);
  Collect("frontend", settings->frontend, &keys);
  Collect("radio_map", settings->survey, &keys);
  Collect("radio_map", settings->radio_map, &keys);
  Collect("map_change", settings->map_change, &keys);
  Collect("solver", settings->solver, &keys);
  Collect("window", settings->window, &keys);
  Collect("baselines", settings->baselines, &keys);
  Collect("scoring", settings->scoring, &keys);
  return keys;
}

std::string FormatNumber(double value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), end.ptr);
}

template <typename Number>
bool ParseWhole(const std::string& text, Number* value) {
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, *value);
  return parsed.ec == std::errc() && parsed.ptr == end;
}

template <typename Number>
std::string AssignNumber(const ConfigKey& key, const std::string& text, Number* target) {
  Number value{};
  if (!ParseWhole(text, &value)) {
    return std::is_integral_v<Number> ? "a whole number" : "a number";
  }
  if constexpr (std::is_floating_point_v<Number>) {
    if (!std::isfinite(value)) return "a finite number";
  }
  if (key.must_be_positive && (value < Number{} || (value == Number{} && !key.may_be_zero))) {
    return key.may_be_zero ? "a number that is not negative" : "a positive number";
  }
  *target = value;
  return "";
}

std::string AssignBool(const std::string& text, bool* target) {
  if (text != "true" && text != "false") return "true or false";
  *target = text == "true";
  return "";
}

std::string AssignEnum(const std::string& text, const EnumKey& target) {
  std::string expected;
  for (std::size_t i = 0; i < target.names.size(); ++i) {
    if (text == target.names[i]) {
      *target.value = static_cast<std::uint8_t>(i);
      return "";
    }
    expected += (i == 0 ? "" : i + 1 == target.names.size() ? " or " : ", ");
    expected += target.names[i];
  }
  return expected;
}

}  // namespace

std::vector<ConfigKey> ConfigKeys(Settings* settings) {
  std::vector<ConfigKey> keys = CollectKeys(settings);
  // Whether zero is allowed hangs on the default, not on what the field holds now.
  Settings defaults;
  const std::vector<ConfigKey> default_keys = CollectKeys(&defaults);
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i].may_be_zero = default_keys[i].may_be_zero;
  return keys;
}

std::string FormatValue(const ConfigKey& key) {
  struct Formatter {
    std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
    std::string operator()(const int* value) const { return std::to_string(*value); }
    std::string operator()(const double* value) const { return FormatNumber(*value); }
    std::string operator()(const EnumKey& key) const { return std::string(key.names[*key.value]); }
  };
  return std::visit(Formatter{}, key.target);
}

std::string AssignValue(const ConfigKey& key, const std::string& text) {
  if (auto* const* value = std::get_if<bool*>(&key.target)) return AssignBool(text, *value);
  if (auto* const* value = std::get_if<int*>(&key.target)) return AssignNumber(key, text, *value);
  if (auto* const* value = std::get_if<double*>(&key.target))
    return AssignNumber(key, text, *value);
  return AssignEnum(text, std::get<EnumKey>(key.target));
}

}  // namespace walkgraph
