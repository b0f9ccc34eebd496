#include <cstdio>

#include "common_flags.h"
#include "data/dataset.h"
#include "data/input_error.h"
#include "eval/evaluate.h"
#include "eval/inspect.h"
#include "eval/usage_error.h"
#include "verbs.h"

DEFINE_bool(json, false, "print one JSON list instead of tables");

namespace walkgraph {
namespace {

void Print(const Inspection& inspection, const char* separator) {
  std::fputs(separator, stdout);
  const std::string text =
      FLAGS_json ? FormatInspectionJson(inspection) : FormatInspection(inspection);
  std::fputs(text.c_str(), stdout);
}

// Prints the walks at `path` and appends what was found.
void InspectPath(const std::string& path, const FrontendSettings& settings,
                 std::vector<Inspection>* found) {
  const Dataset walks = OpenDataset(path);
  for (const WalkFile& file : walks.walks) {
    found->push_back(InspectWalk(ReadWalk(file, settings.reader), walks.building, settings));
    Print(found->back(), found->size() == 1 ? "" : FLAGS_json ? ",\n" : "\n");
  }
}

int RunInspect(const CommandLine& line) {
  if (line.arguments.empty()) throw UsageError("inspect: expected at least one RECORDING");
  const Settings settings = ReadSettings(line);
  std::vector<Inspection> found;
  if (FLAGS_json) std::fputs("[", stdout);
  for (const std::string& path : line.arguments) {
    try {
      InspectPath(path, settings.frontend, &found);
    } catch (const InputError& error) {  // the other recordings are still worth looking at
      std::fprintf(stderr, "walkgraph: %s\n", error.what());
    }
  }
  if (FLAGS_json) {
    std::fputs("]\n", stdout);
  } else {
    std::printf("\n%s", FormatSensorSummary(found).c_str());
  }
  return found.empty() ? kExitBadInput : kExitOk;
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
