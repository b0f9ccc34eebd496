#include "common_flags.h"

#include <algorithm>
#include <csignal>
#include <optional>
#include <thread>

#include "eval/usage_error.h"

DEFINE_string(config, "", "YAML file with settings; `walkgraph config` prints them all");
DEFINE_string(set, "", "one setting, KEY=VALUE; may be given several times, wins over --config");
DEFINE_string(dataset, "", "folder of recorded walks, of any known format");
DEFINE_string(
    floor, "unknown",
    "whether methods are told the floor: unknown, or given (by the folder, the name of the "
    "file or the waypoints; a walk that changes floors is not told any)");
DEFINE_int32(folds, 5, "parts of the cross-validation");
DEFINE_string(split, "walk", "what stays together: walk, session, trial, phone or block");
DEFINE_bool(tum, false, "write trajectories in TUM format too");
DEFINE_string(out, "", "where results go");
DEFINE_string(lag, "", "0 makes `window` report each pose at once instead of when it leaves");
DEFINE_int32(workers, 0, "walks worked on at once; 0 takes the number of cores");

namespace walkgraph {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void OnInterrupt(int /*signal*/) {
  interrupted = 1;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

std::vector<ConfigOverride> ReadOverrides(const CommandLine& line) {
  std::vector<ConfigOverride> overrides;
  if (!FLAGS_config.empty()) overrides = ReadConfigFile(FLAGS_config);
  for (const std::string& assignment : line.assignments) {
    overrides.push_back(ParseSetFlag(assignment));
  }
  if (!FLAGS_lag.empty()) {
    if (FLAGS_lag != "0") throw UsageError("--lag=" + FLAGS_lag + ": expected 0");
    overrides.push_back(ParseSetFlag("window.report_newest=true"));
  }
  return overrides;
}

Settings ReadSettings(const CommandLine& line) {
  Settings settings;
  ApplyOverrides(ReadOverrides(line), &settings);
  return settings;
}

int Workers() {
  if (FLAGS_workers < 0) throw UsageError("--workers: expected a number that is not negative");
  if (FLAGS_workers > 0) return FLAGS_workers;
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

bool FloorGiven() {
  if (FLAGS_floor != "given" && FLAGS_floor != "unknown") {
    throw UsageError("--floor=" + FLAGS_floor + ": expected given or unknown");
  }
  return FLAGS_floor == "given";
}

SplitBy SplitOfFlags() {
  const std::optional<SplitBy> split = SplitByName(FLAGS_split);
  if (split) return *split;
  throw UsageError("--split=" + FLAGS_split + ": expected walk, session, trial, phone or block");
}

int Folds() {
  if (FLAGS_folds < 2) throw UsageError("--folds: expected at least 2");
  return FLAGS_folds;
}

void RequireFlag(const char* name, const std::string& value) {
  if (value.empty()) throw UsageError(std::string("--") + name + " is missing");
}

void RequireNoArguments(const CommandLine& line) {
  if (line.arguments.empty()) return;
  throw UsageError("unexpected argument \"" + line.arguments.front() + "\"");
}

bool Interrupted() { return interrupted != 0; }

void HandleInterrupt() { std::signal(SIGINT, OnInterrupt); }

}  // namespace walkgraph
