#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "common_flags.h"
#include "data/simulator/sample.h"
#include "data/simulator/scenarios.h"
#include "data/simulator/write_simulation.h"
#include "eval/evaluate.h"
#include "eval/files.h"
#include "eval/suggest.h"
#include "eval/usage_error.h"
#include "simulation_keys.h"
#include "verbs.h"

DECLARE_string(test);
DEFINE_int32(seed, 1, "of the random numbers; the same seed gives the same bytes");
DEFINE_string(scenario, "sample",
              "sample, office, hall, clean, or clean with one disturbance: gyro_bias, "
              "heading_offset, step_scale, baro_offset, map_change");
DEFINE_string(format, "csv", "csv, ilc20 (walks stay on their floors) or getsensordata");
DEFINE_string(plan, "", "building.json to walk in, in place of the scenario's building");
DEFINE_string(floors, "", "number of floors");
DEFINE_string(survey, "", "number of survey walks");
DEFINE_string(duration_s, "", "of a walk, about, s");
DEFINE_string(rate_hz, "", "of accelerometer and gyroscope, Hz");

namespace walkgraph {
namespace {

constexpr char kSample[] = "sample";
constexpr double kLongestWalkS = 3600;

// Flags that stand for a key of the settings.
std::array<std::pair<const char*, std::string>, 5> Shortcuts() {
  return {{{"floors", FLAGS_floors},
           {"survey", FLAGS_survey},
           {"test", FLAGS_test},
           {"duration_s", FLAGS_duration_s},
           {"rate_hz", FLAGS_rate_hz}}};
}

SimulationFormat FormatOf(const std::string& name) {
  for (std::size_t i = 0; i < kSimulationFormatNames.size(); ++i) {
    if (name == kSimulationFormatNames[i]) return static_cast<SimulationFormat>(i);
  }
  throw UsageError("--format=" + name + ": expected csv, ilc20 or getsensordata");
}

SimulationSettings ReadSimulationSettings(const CommandLine& line, SimulationFormat format) {
  std::optional<SimulationSettings> settings = ScenarioSettings(FLAGS_scenario);
  if (!settings) {
    std::vector<std::string> names = ScenarioNames();
    names.emplace_back(kSample);
    throw UsageError("--scenario: unknown scenario \"" + FLAGS_scenario + "\"" +
                     DidYouMean(FLAGS_scenario, names) + ", expected one that `walkgraph help " +
                     "simulate` lists");
  }
  if (!FLAGS_plan.empty()) settings->building.kind = BuildingKind::kGiven;
  if (format == SimulationFormat::kIlc20) settings->walks.change_floors = false;
  for (const auto& [flag, value] : Shortcuts()) {
    const bool building = std::string(flag) == "floors";
    const std::string key = (building ? "building." : "walks.") + std::string(flag);
    if (!value.empty()) {
      AssignSimulationKey(key, value, std::string("--") + flag, &*settings);
    }
  }
  for (const std::string& assignment : line.assignments) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos)
      throw UsageError("--set " + assignment + ": expected KEY=VALUE");
    AssignSimulationKey(assignment.substr(0, equals), assignment.substr(equals + 1), "--set",
                        &*settings);
  }
  if (settings->walks.duration_s > kLongestWalkS) {
    throw UsageError("--duration_s: expected an hour (3600) or less");
  }
  return *settings;
}

// The sample is a fixed set of bytes: it has no settings.
int RunSample(const CommandLine& line, std::uint64_t seed) {
  const auto shortcuts = Shortcuts();
  const bool set = std::any_of(shortcuts.begin(), shortcuts.end(),
                               [](const auto& shortcut) { return !shortcut.second.empty(); });
  if (set || !line.assignments.empty() || !FLAGS_plan.empty() || FLAGS_format != "csv") {
    throw UsageError("--scenario=sample takes --out and --seed alone, expected another scenario");
  }
  SimulateSample(FLAGS_out, seed);
  std::printf("%s: building.json, survey/ and test/\n", FLAGS_out.c_str());
  return kExitOk;
}

int RunSimulate(const CommandLine& line) {
  RequireNoArguments(line);
  RequireFlag("out", FLAGS_out);
  if (FLAGS_seed < 0) throw UsageError("--seed: expected a number that is not negative");
  const auto seed = static_cast<std::uint64_t>(FLAGS_seed);
  if (FLAGS_scenario == kSample) return RunSample(line, seed);
  const SimulationFormat format = FormatOf(FLAGS_format);
  const SimulationSettings settings = ReadSimulationSettings(line, format);
  const Simulation simulation =
      FLAGS_plan.empty() ? Simulation(settings, seed) : Simulation(settings, seed, FLAGS_plan);
  WriteSimulation(simulation, format, FLAGS_out);
  WriteFileWhole(FLAGS_out + "/simulation.yaml", "# scenario " + FLAGS_scenario + ", seed " +
                                                     std::to_string(FLAGS_seed) + "\n" +
                                                     PrintSimulationSettings(settings));
  std::printf("%s: building.json, simulation.yaml, survey/ (%d walks) and test/ (%d walks)\n",
              FLAGS_out.c_str(), settings.walks.survey, settings.walks.test);
  return kExitOk;
}

}  // namespace

Verb SimulateVerb() {
  return {"simulate",
          "--out=DIR [--scenario=NAME] [--set KEY=VALUE...]",
          "make a building and walks with exact truth",
          {"out", "seed", "scenario", "format", "plan", "floors", "survey", "test", "duration_s",
           "rate_hz", "set"},
          RunSimulate};
}

}  // namespace walkgraph
