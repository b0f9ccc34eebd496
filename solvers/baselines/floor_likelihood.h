#ifndef WALKGRAPH_SOLVERS_BASELINES_FLOOR_LIKELIHOOD_H_
#define WALKGRAPH_SOLVERS_BASELINES_FLOOR_LIKELIHOOD_H_

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// What a sweep of a radio adds to what is known about the floor.
struct FloorLook {
  TimeNs mean_heard_ns = 0;
  TimeNs printed_ns = 0;           // when all of it was known
  Eigen::VectorXd log_likelihood;  // by floor, nats, up to a constant
};

// How floors sound, by the survey's own readings. A look is all that a radio heard in one
// correlation time of its errors (noise.floor.correlation_s), the mean of each transmitter. The
// likelihood of a look on a floor is that of a mixture of kernels, one for each look of the survey
// there, with
//   -log k = 1/2 w sum over transmitters of min((q - r)^2 / s^2, 25),  w = min(1, n_eff / heard),
// q and r the strengths in the look and the survey's (settings.missing_dbm where one was not
// heard), s settings.spread_db; and of the whole building's looks on every floor with the weight
// settings.background: of a floor that was hardly surveyed it is hardly known how it sounds. One
// scale serves all floors, which maps that are calibrated one by one do not offer.
//
// Walk and survey are cut into stretches of that length. What each sweep of the walk says is by how
// much it changes the log likelihood of the look that its stretch has been so far, so that a
// stretch says what its whole look says, and a window need not wait for it to be whole.
class FloorSounds {
 public:
  // Keeps references to both.
  FloorSounds(const Site& site, const FactorSettings& settings);

  // Log of the share of each floor in the survey's looks, each floor with one more: where people
  // go.
  Eigen::VectorXd LogPrior(const std::vector<int>& floors) const;

  // The looks of a walk by the radios that are switched on, in order of their mean time heard.
  // Those that the site knows nothing of are left out.
  std::vector<FloorLook> Looks(const Evidence& evidence, const std::vector<int>& floors) const;

 private:
  using Signals = std::vector<std::pair<std::uint32_t, float>>;  // transmitter and mean dBm
  struct SurveyLook {
    int floor = 0;
    Radio radio = Radio::kWifi;
    Signals signals;
  };

  void AppendLooks(const Evidence& evidence, Radio radio, const std::vector<int>& floors,
                   std::vector<FloorLook>* looks) const;
  Eigen::VectorXd LogLikelihood(Radio radio, const std::vector<int>& floors,
                                const Signals& heard) const;

  const Site& site_;
  const FactorSettings& settings_;
  std::vector<SurveyLook> survey_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_FLOOR_LIKELIHOOD_H_
