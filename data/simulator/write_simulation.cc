#include "data/simulator/write_simulation.h"

#include <cstddef>
#include <filesystem>
#include <system_error>
#include <vector>

#include "data/formats/csv.h"
#include "data/input_error.h"

namespace walkgraph {
namespace {

namespace fs = std::filesystem;

constexpr double kPathEveryS = 0.1;

void MakeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder.string(), 0, error.message(), "a folder that can be made");
}

std::vector<PathPoint> ExactPath(const Plan& plan, const std::vector<WalkState>& states) {
  std::vector<PathPoint> path;
  for (const WalkState& state : states) {
    const bool due =
        path.empty() || SecondsBetween(path.back().time_ns, state.time_ns) >= kPathEveryS;
    if (!due && &state != &states.back()) continue;
    path.push_back({state.time_ns,
                    {state.position_m.x(), state.position_m.y(), state.height_m},
                    plan.FloorAt(state.height_m),
                    state.heading_rad});
  }
  return path;
}

void WriteCsv(const SimulatedWalk& walk, const Plan& plan, const fs::path& out_dir) {
  const fs::path folder = out_dir / walk.name;
  WriteCsvWalk(walk.recording, walk.truth, CsvPrecision{}, folder.string());
  WritePathCsv(ExactPath(plan, walk.path), (folder / "path.csv").string());
}

}  // namespace

void WriteSimulation(const Simulation& simulation, SimulationFormat format,
                     const std::string& out_dir) {
  MakeFolder(out_dir);
  const Plan& plan = simulation.plan();
  WriteBuildingJson(plan.building, (fs::path(out_dir) / "building.json").string());
  for (int i = 0; i < simulation.walk_count(); ++i) {
    const SimulatedWalk walk = simulation.MakeWalk(i);
    if (format == SimulationFormat::kCsv) WriteCsv(walk, plan, out_dir);
  }
}

}  // namespace walkgraph
