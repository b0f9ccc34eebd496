#ifndef WALKGRAPH_DATA_SIMULATOR_RADIO_H_
#define WALKGRAPH_DATA_SIMULATOR_RADIO_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "data/recording.h"
#include "data/simulator/motion.h"
#include "data/simulator/plan.h"
#include "data/simulator/random.h"

namespace walkgraph {

// A stationary random field over the plane with mean 0, sigma 1 and correlation exp(-d / length): a
// sum of plane waves whose wave numbers follow the spectrum of that correlation in two dimensions.
class ShadowField {
 public:
  ShadowField(double correlation_length_m, Random* random);
  double At(const Eigen::Vector2d& position) const;

 private:
  struct Wave {
    Eigen::Vector2d wave_vector;  // rad/m
    double phase_rad;
  };
  std::vector<Wave> waves_;
};

struct AccessPoint {
  std::string bssid;
  Eigen::Vector2d position_m;
  double power_at_1m_dbm = 0;  // as a phone in a hand receives it
  double sweep_fraction = 0;   // when its channel comes in a sweep
  ShadowField shadow;
};

// Access points on the floor and around it.
std::vector<AccessPoint> PlaceAccessPoints(const Plan& plan, int count, Random* random);

// What a phone receives on average over time and over the directions that a person may face.
double MeanRssiDbm(const Plan& plan, const AccessPoint& access_point,
                   const Eigen::Vector2d& position);

// Wi-Fi sweeps all along a walk, the first one begun before it. Fills transmitters and radio rows
// of `recording`; access points that are never heard get no transmitter.
void SimulateWifi(const Plan& plan, const std::vector<AccessPoint>& access_points,
                  const std::vector<WalkState>& states, Random* random, Recording* recording);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_RADIO_H_
