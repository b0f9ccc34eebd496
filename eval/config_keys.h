#ifndef WALKGRAPH_EVAL_CONFIG_KEYS_H_
#define WALKGRAPH_EVAL_CONFIG_KEYS_H_

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "eval/settings.h"

namespace walkgraph {

// An enumeration in the configuration: its value lives in a byte and is written by name.
struct EnumKey {
  std::uint8_t* value = nullptr;
  std::span<const std::string_view> names;  // by value
};

// One key of the configuration tree, bound to the field of a Settings object that it sets.
struct ConfigKey {
  std::string name;  // full path, "noise.step.sigma_along_m"
  std::string documentation;
  std::variant<bool*, int*, double*, EnumKey> target;
  // Lower limit of a number. A sigma, rate, scale or duration must be positive, since the model
  // divides by it; zero is allowed where the default is zero, which means "take the site's".
  bool must_be_positive = false;
  bool may_be_zero = true;
};

// All keys of `settings` in the order in which they are printed.
std::vector<ConfigKey> ConfigKeys(Settings* settings);

// The value as the configuration file writes it: the shortest text that reads back to the same.
std::string FormatValue(const ConfigKey& key);

// Sets the bound field. Returns an empty string, or what was expected instead of `text` (the field
// is then unchanged).
std::string AssignValue(const ConfigKey& key, const std::string& text);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_CONFIG_KEYS_H_
