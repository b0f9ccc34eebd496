#ifndef WALKGRAPH_EVAL_CONFIG_H_
#define WALKGRAPH_EVAL_CONFIG_H_

#include <map>
#include <string>
#include <vector>

#include "eval/settings.h"

namespace walkgraph {

// The configuration is one tree of keys:
//   noise.<factor>.<key>     numbers of the factors and slow states (sigmas, rates, knots)
//   factors.<factor>.<key>   their switches (enabled, mode, loss)
//   frontend.<part>.<key>    how streams become evidence
//   radio_map.<key>          how a survey becomes a map
//   solver.<key>             how the graph is solved
//   window.<key>             what the sliding window adds
//   baselines.<method>.<key> what they do not share with the graph
//   scoring.<key>            how estimates are scored
// `walkgraph config` prints it, with documentation and defaults, as YAML that reads back.

// A value that the user set: it wins over defaults and over calibration.
struct ConfigOverride {
  std::string key;    // "noise.step.sigma_along_m"
  std::string text;   // as written
  std::string place;  // "my.yaml:7" or "--set", for messages
};

// The keys that a YAML file sets, each checked against the tree and its value against the type.
// Throws InputError with file:line for a file that is missing or not YAML, a key that is unknown or
// given twice, and a value of the wrong kind or out of range (not finite, a sigma that is
// negative).
std::vector<ConfigOverride> ReadConfigFile(const std::string& path);

// One `key=value` of the command line. Throws UsageError as above.
ConfigOverride ParseSetFlag(const std::string& assignment);

// Writes the values into `settings`, later ones over earlier ones. Precondition: the overrides come
// from the functions above.
void ApplyOverrides(const std::vector<ConfigOverride>& overrides, Settings* settings);

// The keys whose values differ, with the value in `changed`.
std::map<std::string, std::string> ChangedValues(const Settings& base, const Settings& changed);

// The whole tree as documented YAML.
std::string PrintConfig(const Settings& settings);

// Only the keys that differ from `base`, as YAML in the same form.
std::string PrintChanges(const Settings& base, const Settings& changed);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_CONFIG_H_
