#ifndef WALKGRAPH_DATA_SIMULATOR_SIMULATION_H_
#define WALKGRAPH_DATA_SIMULATOR_SIMULATION_H_

#include <cstdint>
#include <string>
#include <vector>

#include "data/simulator/magnetic.h"
#include "data/simulator/plan.h"
#include "data/simulator/radio.h"
#include "data/simulator/random.h"
#include "data/simulator/settings.h"
#include "data/simulator/simulated_walk.h"

namespace walkgraph {

// A building and walks through it, drawn from a seed. Every walk is made when it is asked for and
// depends on nothing but settings, seed and its number; every walk has another person and another
// phone. The building is drawn from random numbers that the walks do not touch, and so is each
// disturbance: switching one off changes nothing else.
class Simulation {
 public:
  // A building of the kind that the settings name. Precondition: not BuildingKind::kGiven.
  Simulation(const SimulationSettings& settings, std::uint64_t seed);
  // In the building of a file. Throws InputError where nobody could walk in it.
  Simulation(const SimulationSettings& settings, std::uint64_t seed, const std::string& plan_path);

  const SimulationSettings& settings() const { return settings_; }
  const Plan& plan() const { return plan_; }
  const std::vector<Sender>& survey_senders() const { return survey_senders_; }
  const std::vector<Sender>& test_senders() const { return test_senders_; }

  int walk_count() const { return settings_.walks.survey + settings_.walks.test; }
  // Survey walks come first: "survey/walk_01". Precondition: 0 <= index < walk_count().
  SimulatedWalk MakeWalk(int index) const;

 private:
  Simulation(const SimulationSettings& settings, std::uint64_t seed, Plan plan);
  void SimulateSensors(const std::vector<WalkState>& states, const Gait& gait, const Random& random,
                       Recording* recording) const;
  void SimulateRadio(const std::vector<WalkState>& states, bool survey, const Random& random,
                     Recording* recording) const;
  double RotationRad() const;

  SimulationSettings settings_;
  Random random_;
  Plan plan_;
  MagneticField field_;
  std::vector<int> starts_;  // links in the order in which survey walks begin on them
  std::vector<Sender> survey_senders_;
  std::vector<Sender> test_senders_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_SIMULATION_H_
