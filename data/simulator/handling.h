#ifndef WALKGRAPH_DATA_SIMULATOR_HANDLING_H_
#define WALKGRAPH_DATA_SIMULATOR_HANDLING_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

#include "data/simulator/random.h"

namespace walkgraph {

// A phone that is waved in figures of eight before the walk, to calibrate its compass, and that
// comes to rest in the hand within a second.
class Handling {
 public:
  // Lasts `duration_s` from the beginning of the recording.
  Handling(double duration_s, Random random);

  // Of the phone against how the hand holds it afterwards.
  Eigen::Quaterniond Rotation(double time_s) const;
  // Of the phone in building axes, m/s^2.
  Eigen::Vector3d Acceleration(double time_s) const;

 private:
  struct Swing {
    double frequency_hz = 0;
    double phase_rad = 0;
    double At(double time_s) const;
  };
  double Strength(double time_s) const;

  double duration_s_;
  std::array<Swing, 3> rotation_;
  std::array<Swing, 3> motion_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_HANDLING_H_
