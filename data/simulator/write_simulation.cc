#include "data/simulator/write_simulation.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "data/formats/csv.h"
#include "data/formats/getsensordata.h"
#include "data/formats/ilc20.h"
#include "data/formats/text_output.h"
#include "data/input_error.h"

namespace walkgraph {
namespace {

namespace fs = std::filesystem;

constexpr double kPathEveryS = 0.1;
constexpr char kBuildingFile[] = "building.json";

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

// Writes walks of one format below a folder.
class WalkWriter {
 public:
  WalkWriter(const Plan& plan, SimulationFormat format, fs::path out_dir)
      : plan_(plan), format_(format), out_dir_(std::move(out_dir)) {}

  void WriteBuilding() const;
  void WriteWalk(const SimulatedWalk& walk) const;

 private:
  void WriteIlc20(const SimulatedWalk& walk) const;
  void WriteLog(const SimulatedWalk& walk) const;

  const Plan& plan_;
  SimulationFormat format_;
  fs::path out_dir_;
};

void WalkWriter::WriteBuilding() const {
  MakeFolder(out_dir_.string());
  WriteBuildingJson(plan_.building, (out_dir_ / kBuildingFile).string());
  if (format_ != SimulationFormat::kIlc20) return;
  // A site describes its floors, but not how high they lie: building.json comes first.
  for (const char* set : {"survey", "test"}) {
    for (const Floor& floor : plan_.building.floors) {
      const fs::path folder = out_dir_ / set / Ilc20FloorName(floor.number);
      WriteIlc20Floor(floor, plan_.building.origin.value_or(GeoReference{}), folder.string());
      MakeFolder((folder / "path_data_files").string());
    }
    WriteBuildingJson(plan_.building, (out_dir_ / set / kBuildingFile).string());
  }
}

void WalkWriter::WriteIlc20(const SimulatedWalk& walk) const {
  const std::vector<Waypoint>& waypoints = walk.truth.waypoints;
  const int floor = waypoints.front().floor;
  const bool one_floor =
      std::all_of(waypoints.begin(), waypoints.end(),
                  [floor](const Waypoint& waypoint) { return waypoint.floor == floor; });
  if (!one_floor) {
    throw InputError(walk.name, 0, "a walk over several floors",
                     "walks that stay on their floor, for ilc20 knows no others");
  }
  const fs::path name = walk.name;
  const fs::path folder = out_dir_ / name.parent_path() / Ilc20FloorName(floor) / "path_data_files";
  const std::string stem = (folder / name.filename()).string();
  WriteIlc20Walk(walk.recording, walk.truth, stem + ".txt");
  WritePathCsv(ExactPath(plan_, walk.path), stem + ".path.csv");
}

void WalkWriter::WriteLog(const SimulatedWalk& walk) const {
  if (!plan_.building.origin) {
    throw InputError(walk.name, 0, "the building has no geographic origin",
                     "an origin in the plan, for GetSensorData logs are in degrees");
  }
  const std::string stem = (out_dir_ / walk.name).string();
  MakeFolder(fs::path(stem).parent_path().string());
  WriteGetSensorData(walk.recording, ToWgs84(walk.truth, plan_.building), stem + ".txt");
  WritePathCsv(ExactPath(plan_, walk.path), stem + ".path.csv");
}

void WalkWriter::WriteWalk(const SimulatedWalk& walk) const {
  if (format_ == SimulationFormat::kIlc20) return WriteIlc20(walk);
  if (format_ == SimulationFormat::kGetSensorData) return WriteLog(walk);
  const fs::path folder = out_dir_ / walk.name;
  WriteCsvWalk(walk.recording, walk.truth, CsvPrecision{}, folder.string());
  WritePathCsv(ExactPath(plan_, walk.path), (folder / "path.csv").string());
}

}  // namespace

void WriteSimulation(const Simulation& simulation, SimulationFormat format,
                     const std::string& out_dir) {
  const WalkWriter writer(simulation.plan(), format, out_dir);
  writer.WriteBuilding();
  for (int i = 0; i < simulation.walk_count(); ++i) writer.WriteWalk(simulation.MakeWalk(i));
}

}  // namespace walkgraph
