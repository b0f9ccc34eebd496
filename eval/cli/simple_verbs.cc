// The verbs that only print.
#include <cstdio>

#include "common_flags.h"
#include "eval/config.h"
#include "eval/evaluate.h"
#include "eval/methods.h"
#include "eval/version.h"
#include "verbs.h"

namespace walkgraph {
namespace {

int RunConfig(const CommandLine& line) {
  RequireNoArguments(line);
  std::fputs(PrintConfig(ReadSettings(line)).c_str(), stdout);
  return kExitOk;
}

void Print(std::string_view label, std::string_view text) {
  std::printf("%-14.*s %.*s\n", static_cast<int>(label.size()), label.data(),
              static_cast<int>(text.size()), text.data());
}

int RunMethods(const CommandLine& line) {
  RequireNoArguments(line);
  for (const Method& method : Methods()) {
    const MethodDescription& text = method.description;
    Print(method.name, text.summary);
    Print("", text.source);
    if (!text.own_choices.empty()) Print("  our choice:", text.own_choices);
    if (method.floor_by_floor) {
      Print("  several floors:", "anew on every stay, the floors those of `viterbi` (our choice)");
    }
  }
  return kExitOk;
}

int RunVersion(const CommandLine& line) {
  RequireNoArguments(line);
  const std::string_view version = Version();
  std::printf("walkgraph %.*s\n", static_cast<int>(version.size()), version.data());
  return kExitOk;
}

}  // namespace

Verb ConfigVerb() {
  return {"config",
          "",
          "print all settings with their documentation, as YAML that reads back",
          {"config", "set"},
          RunConfig};
}

Verb MethodsVerb() { return {"methods", "", "list the methods", {}, RunMethods}; }

Verb VersionVerb() { return {"version", "", "print the version", {}, RunVersion}; }

}  // namespace walkgraph
