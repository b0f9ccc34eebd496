#ifndef WALKGRAPH_DATA_SIMULATOR_WRITE_SIMULATION_H_
#define WALKGRAPH_DATA_SIMULATOR_WRITE_SIMULATION_H_

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "data/simulator/simulation.h"

namespace walkgraph {

enum class SimulationFormat : std::uint8_t { kCsv, kIlc20, kGetSensorData };
inline constexpr std::array<std::string_view, 3> kSimulationFormatNames = {"csv", "ilc20",
                                                                           "getsensordata"};

// Writes the building and all walks below `out_dir`, which is made where it does not exist:
// building.json, and the data sets survey/ and test/ in the layout of the format, each walk with
// its exact path (see data/formats/README.md). The same seed and settings give the same bytes.
// Throws InputError where a file cannot be written, and where the format cannot hold the walks:
// ilc20 knows no walks over several floors.
void WriteSimulation(const Simulation& simulation, SimulationFormat format,
                     const std::string& out_dir);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_WRITE_SIMULATION_H_
