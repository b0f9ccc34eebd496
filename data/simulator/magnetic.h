#ifndef WALKGRAPH_DATA_SIMULATOR_MAGNETIC_H_
#define WALKGRAPH_DATA_SIMULATOR_MAGNETIC_H_

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "data/recording.h"
#include "data/simulator/motion.h"
#include "data/simulator/random.h"
#include "data/simulator/settings.h"
#include "data/simulator/shadow_field.h"

namespace walkgraph {

// The magnetic field in a building: Earth's and, of steel that stays where it is, a random field
// without mean. Building axes, microtesla.
class MagneticField {
 public:
  MagneticField(const MagneticSettings& settings, double rotation_rad, Random* random);
  Eigen::Vector3d At(const Eigen::Vector3d& position_m) const;

 private:
  Eigen::Vector3d earth_ut_;
  double disturbance_ut_;
  std::array<ShadowField, 3> disturbance_;
};

// Fills rotation vector and magnetic field of `recording`. `rotation_rad` is the angle from east to
// the building frame's x. The rotation vector takes its north from the field, slowly, with an error
// of its own on top.
void SimulateMagnetic(const std::vector<WalkState>& states,
                      const std::vector<Eigen::Quaterniond>& attitudes, const MagneticField& field,
                      const MagneticSettings& settings, double rotation_rad, Random* random,
                      Recording* recording);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_MAGNETIC_H_
