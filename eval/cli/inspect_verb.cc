#include <cstdio>

#include "common_flags.h"
#include "data/dataset.h"
#include "data/input_error.h"
#include "eval/evaluate.h"
#include "eval/inspect.h"
#include "eval/loaded_walk.h"
#include "eval/usage_error.h"
#include "verbs.h"

DEFINE_bool(json, false, "print one JSON list instead of tables");

namespace walkgraph {
namespace {

// Prints one walk; `separator` goes before it.
void Print(const Inspection& inspection, const char* separator) {
  std::fputs(separator, stdout);
  const std::string text =
      FLAGS_json ? FormatInspectionJson(inspection) : FormatInspection(inspection);
  std::fputs(text.c_str(), stdout);
}

int RunInspect(const CommandLine& line) {
  if (line.arguments.empty()) throw UsageError("inspect: expected at least one RECORDING");
  const Settings settings = ReadSettings(line);
  int inspected = 0;
  if (FLAGS_json) std::fputs("[", stdout);
  for (const std::string& path : line.arguments) {
    try {
      for (const WalkFile& file : WalksAt(path)) {
        const char* separator = FLAGS_json ? ",\n" : "\n";
        Print(InspectWalk(ReadWalk(file), settings.frontend), inspected > 0 ? separator : "");
        ++inspected;
      }
    } catch (const InputError& error) {  // the other recordings are still worth looking at
      std::fprintf(stderr, "walkgraph: %s\n", error.what());
    }
  }
  if (FLAGS_json) std::fputs("]\n", stdout);
  return inspected > 0 ? kExitOk : kExitBadInput;
}

}  // namespace

Verb InspectVerb() {
  return {"inspect",
          "RECORDING...",
          "streams, rates, gaps, clocks and hazards of recordings",
          {"json", "config", "set"},
          RunInspect};
}

}  // namespace walkgraph
