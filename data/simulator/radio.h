#ifndef WALKGRAPH_DATA_SIMULATOR_RADIO_H_
#define WALKGRAPH_DATA_SIMULATOR_RADIO_H_

#include <Eigen/Core>
#include <string>
#include <vector>

#include "data/recording.h"
#include "data/simulator/motion.h"
#include "data/simulator/plan.h"
#include "data/simulator/random.h"
#include "data/simulator/settings.h"
#include "data/simulator/shadow_field.h"

namespace walkgraph {

// An access point or a beacon.
struct Sender {
  Radio radio = Radio::kWifi;
  std::string name;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  int floor = 0;
  bool outside = false;        // of the floor's outline
  double power_at_1m_dbm = 0;  // as a phone in a hand receives it
  double phase = 0;            // 0..1: when its channel comes in a sweep, when it advertises
  ShadowField shadow;
};

// Access points on the floors and around them.
std::vector<Sender> PlaceAccessPoints(const Plan& plan, const SimulationSettings& settings,
                                      Random* random);

// Beacons along the ways.
std::vector<Sender> PlaceBeacons(const Plan& plan, const SimulationSettings& settings,
                                 Random* random);

// The senders when some have fallen silent and others have got another power. They keep their
// places, so that the random numbers of a walk fall to the same ones.
std::vector<Sender> ChangeSenders(std::vector<Sender> senders, const ChangeSettings& settings,
                                  Random random);

// COST 231: loss of `floors` floors between sender and phone, dB.
double FloorLossDb(const PropagationSettings& settings, int floors);

// What a phone receives on average over time and over the directions that a person may face, on a
// floor with the feet at `height_m`.
double MeanRssiDbm(const Plan& plan, const Sender& sender, const Eigen::Vector2d& position_m,
                   double height_m, const PropagationSettings& settings);

// One reading: the mean, the shadow of the body and the noise of one reading, dBm.
double DrawRssiDbm(const Plan& plan, const Sender& sender, const WalkState& state,
                   const PropagationSettings& settings, Random* random);

// The state at a time; the first or last one outside the walk.
const WalkState& StateAt(const std::vector<WalkState>& states, TimeNs time_ns);

// Share of the sweeps in which a reading is refreshed, 0..1 (TCPF's eta).
double RefreshShare(const WifiSettings& settings, double rssi_dbm);

// Wi-Fi sweeps all along a walk, the first one begun before it. Fills transmitters and radio rows
// of `recording`; access points that are never heard get no transmitter.
void SimulateWifi(const Plan& plan, const std::vector<Sender>& access_points,
                  const std::vector<WalkState>& states, const SimulationSettings& settings,
                  Random* random, Recording* recording);

// Advertisements along a walk, each a row of its own, printed when it is heard. Fills as above.
void SimulateBeacons(const Plan& plan, const std::vector<Sender>& beacons,
                     const std::vector<WalkState>& states, const SimulationSettings& settings,
                     Random* random, Recording* recording);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_RADIO_H_
