#include "solvers/baselines/mle.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "factors/dead_reckoning.h"
#include "factors/map_look.h"
#include "factors/map_sweeps.h"
#include "solvers/baselines/discrete.h"
#include "solvers/baselines/likelihood_grid.h"

namespace walkgraph {
namespace {

// -log p over the reference points of what was heard about a moment.
struct Epoch {
  TimeNs time_ns = 0;
  std::vector<double> nats;
};

void Add(const std::vector<float>& nats, Epoch* epoch) {
  epoch->nats.resize(nats.size(), 0.0);
  for (std::size_t i = 0; i < nats.size(); ++i) epoch->nats[i] += nats[i];
}

// Epochs are the scans of the first radio that was heard, which reports of the others join.
std::vector<Epoch> MakeEpochs(const Site& site, int floor, const Evidence& evidence,
                              const FactorSettings& settings, const ReferencePoints& points) {
  std::vector<Epoch> epochs;
  for (const Radio radio : kAllRadios) {
    const RadioMap* map = site.FindMap(floor, radio);
    if (map == nullptr || !settings.fingerprint.Uses(radio)) continue;
    const std::vector<MapSweep> sweeps =
        CollectMapSweeps(site, *map, evidence, settings.fingerprint);
    const LikelihoodGrid grid(*map, points.positions_m(),
                              PriorOfRssiOffset(site, evidence, radio, settings.rssi_offset),
                              settings.fingerprint.loss);
    const auto nats = grid.Evaluate(sweeps);
    std::vector<TimeNs> times;
    for (const Epoch& epoch : epochs) times.push_back(epoch.time_ns);
    const bool join = !epochs.empty();
    for (std::size_t s = 0; s < sweeps.size(); ++s) {
      if (!join) epochs.push_back({sweeps[s].mean_heard_ns, {}});
      Add(nats[s], join ? &epochs[NearestTime(times, sweeps[s].mean_heard_ns)] : &epochs.back());
    }
  }
  return epochs;
}

// Variance per axis that all scans at a place share and no likelihood knows.
double MapErrorVariance(const RadioMap* map, const MapErrorSettings& settings,
                        const Eigen::Vector2d& position) {
  if (settings.mode == StateMode::kAbsent) return 0;
  if (map == nullptr) return settings.sigma_m * settings.sigma_m;
  const double sigma = settings.sigma_m > 0 ? settings.sigma_m : map->map_error_sigma_m;
  const double error =
      sigma * ErrorRatioAt(*map, GrowthPerSigma(*map, settings, sigma), position).value;
  return error * error;
}

}  // namespace

EstimateResult MleEstimator::Estimate(const Site& site, const Evidence& evidence) const {
  const DeadReckonedPath path = DeadReckon(site, evidence, factors_);
  const int floor = WalkFloor(site, evidence, wknn_);
  const ReferencePoints points(site, floor, settings_.points);
  if (points.empty()) {
    return UnlocatedResult(site, evidence, path, "no survey of floor " + std::to_string(floor));
  }
  const std::vector<Epoch> epochs = MakeEpochs(site, floor, evidence, factors_, points);
  if (epochs.empty()) {
    return UnlocatedResult(site, evidence, path, "no reading that the radio map knows");
  }
  const RadioMap* map = site.FindMap(floor, Radio::kWifi);
  const double quantisation = points.spacing_m() * points.spacing_m() / 12;
  const std::vector<double> uniform(points.size(), 1.0);
  std::vector<PositionFix> fixes;
  for (const Epoch& epoch : epochs) {
    std::vector<double> log_likelihood(epoch.nats.size());
    std::transform(epoch.nats.begin(), epoch.nats.end(), log_likelihood.begin(),
                   [](double nats) { return -nats; });
    PositionFix fix;
    fix.time_ns = epoch.time_ns;
    fix.floor = floor;
    fix.position_m = points.positions_m()[static_cast<std::size_t>(ArgMax(log_likelihood))];
    const double added_variance =
        quantisation + MapErrorVariance(map, factors_.map_error, fix.position_m);
    fix.covariance_m2 = SecondMoment(points.positions_m(),
                                     UpdateDistribution(uniform, log_likelihood), fix.position_m) +
                        added_variance * Eigen::Matrix2d::Identity();
    fixes.push_back(fix);
  }
  EstimateResult result;
  result.trajectory = TrajectoryFromFixes(site, evidence, path, fixes);
  return result;
}

}  // namespace walkgraph
