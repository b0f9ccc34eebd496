#ifndef WALKGRAPH_EVAL_STUDIES_MUFAF_ROOM_ROOM_H_
#define WALKGRAPH_EVAL_STUDIES_MUFAF_ROOM_ROOM_H_

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "solvers/baselines/mufaf/cell_map.h"

namespace walkgraph::mufaf_room {

using Random = std::mt19937_64;

constexpr int kColumns = 7, kRows = 4;  // cells of 1 m
constexpr Eigen::Index kAnchors = 4;    // of every radio, one in each corner
constexpr int kSteps = 90;              // of a route

struct RoomRadio {
  const char* name;
  double exponent, shadowing_db, noise_db;
};
inline constexpr std::array<RoomRadio, 4> kRadios = {
    {{"XBee", 2.2, 2, 2}, {"CC2420", 2.2, 2, 2.5}, {"Wi-Fi", 2.0, 3, 4}, {"Bluetooth", 2.5, 3, 7}}};
constexpr std::size_t kRadioTypes = kRadios.size();

// A smooth Gaussian field of a given spread and a correlation length of 1.5 m: a sum of waves.
class Shadowing {
 public:
  Shadowing(double sigma_db, Random* random);
  double At(const Eigen::Vector2d& p) const;

 private:
  static constexpr int kWaves = 64;
  struct Wave {
    Eigen::Vector2d vector;
    double phase, amplitude;
  };
  std::array<Wave, kWaves> waves_;
};

// The room, what is heard in it and how people walk about. One stream of random numbers: the same
// seed and the same calls give the same room.
class Room {
 public:
  explicit Room(std::uint64_t seed);

  // What the anchors of a radio are expected to hear at a place, dBm.
  Eigen::VectorXd Mean(std::size_t radio, const Eigen::Vector2d& p) const;
  // The mean of so many samples, dBm.
  Eigen::VectorXd Hear(std::size_t radio, const Eigen::Vector2d& p, int samples = 1);
  // A map of that many samples a cell.
  CellMap Survey(std::size_t radio, int samples);
  // kSteps positions, m.
  std::vector<Eigen::Vector2d> Route();

 private:
  Random random_;
  std::vector<std::vector<Shadowing>> shadowing_;  // by radio and anchor
};

}  // namespace walkgraph::mufaf_room

#endif  // WALKGRAPH_EVAL_STUDIES_MUFAF_ROOM_ROOM_H_
