#include "solvers/baselines/floor_tracker.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "solvers/baselines/fixes.h"
#include "solvers/baselines/floor_likelihood.h"
#include "solvers/baselines/floor_model.h"

namespace walkgraph {
namespace {

using Belief = FloorModel::Belief;
constexpr double kEpochS = FloorModel::kEpochS;

std::vector<TimeNs> Epochs(const Evidence& evidence) {
  std::vector<TimeNs> times;
  for (TimeNs t = evidence.begin_ns; t < evidence.end_ns; t += DurationNs(kEpochS)) {
    times.push_back(t);
  }
  times.push_back(std::max(evidence.begin_ns, evidence.end_ns));
  return times;
}

// Multiplies a look's likelihood into an epoch's; on the way between floors any may be heard.
void AddLook(const FloorLook& look, Belief* likelihood) {
  const Eigen::VectorXd p = (look.log_likelihood.array() - look.log_likelihood.maxCoeff()).exp();
  const Eigen::Index floors = p.size();
  likelihood->leftCols(floors) =
      (likelihood->leftCols(floors).array().rowwise() * p.transpose().array()).matrix();
  likelihood->rightCols(1) *= p.mean();
}

std::vector<Belief> Likelihoods(const FloorModel& model, const std::vector<TimeNs>& times,
                                const std::vector<FloorLook>& looks, bool by_print) {
  std::vector<Belief> likelihoods;
  for (const TimeNs time : times) likelihoods.push_back(model.OfPressure(model.HeightAt(time)));
  for (const FloorLook& look : looks) {
    const TimeNs at = by_print ? look.printed_ns : look.mean_heard_ns;
    const auto epoch = std::lower_bound(times.begin(), times.end(), at) - times.begin();
    AddLook(look,
            &likelihoods[std::min<std::size_t>(static_cast<std::size_t>(epoch), times.size() - 1)]);
  }
  return likelihoods;
}

std::vector<Belief> Filter(const FloorModel& model, const std::vector<Belief>& likelihoods) {
  std::vector<Belief> filtered;
  for (std::size_t k = 0; k < likelihoods.size(); ++k) {
    Belief belief = k == 0 ? model.Start() : model.Predict(filtered.back());
    belief = belief.cwiseProduct(likelihoods[k]);
    filtered.push_back(belief / belief.sum());
  }
  return filtered;
}

// What the epochs from `epoch` + 1 to `until` say about `epoch`, `message` what those after `until`
// say about that.
Belief Backward(const FloorModel& model, const std::vector<Belief>& likelihoods, std::size_t epoch,
                std::size_t until, Belief message) {
  for (std::size_t k = until; k > epoch; --k) {
    message = model.Retrodict(message.cwiseProduct(likelihoods[k]));
    message /= message.maxCoeff();
  }
  return message;
}

// Columns: floors and "between"; a row per epoch.
Eigen::MatrixXd Smooth(const FloorModel& model, const std::vector<Belief>& likelihoods,
                       double lag_s) {
  const std::vector<Belief> filtered = Filter(model, likelihoods);
  const std::size_t last = likelihoods.size() - 1;
  const Belief silent = Belief::Ones(filtered.front().rows(), filtered.front().cols());
  Eigen::MatrixXd posterior(static_cast<Eigen::Index>(likelihoods.size()), model.Columns());
  Belief message = silent;
  for (std::size_t k = likelihoods.size(); k-- > 0;) {
    if (!std::isinf(lag_s)) {
      const auto ahead = static_cast<std::size_t>(std::max(0.0, lag_s) / kEpochS);
      message = Backward(model, likelihoods, k, std::min(last, k + ahead), silent);
    } else if (k < last) {
      message = Backward(model, likelihoods, k, k + 1, message);
    }
    const Belief smoothed = filtered[k].cwiseProduct(message);
    posterior.row(static_cast<Eigen::Index>(k)) = smoothed.colwise().sum() / smoothed.sum();
  }
  return posterior;
}

// Runs of epochs on which one floor is the most probable of all.
FloorPath PathOf(const Eigen::MatrixXd& posterior, const std::vector<TimeNs>& times,
                 const std::vector<int>& floors) {
  std::vector<FloorStay> stays;
  Eigen::Index before = -1;
  for (std::size_t k = 0; k < times.size(); ++k) {
    Eigen::Index best = 0;
    posterior.row(static_cast<Eigen::Index>(k)).maxCoeff(&best);
    const bool on_floor = best < static_cast<Eigen::Index>(floors.size());
    if (on_floor && best == before) {
      stays.back().end_ns = times[k];
    } else if (on_floor) {
      stays.push_back({floors[static_cast<std::size_t>(best)], times[k], times[k]});
    }
    before = best;
  }
  if (!stays.empty()) return FloorPath(std::move(stays));
  Eigen::Index best = 0;
  posterior.leftCols(static_cast<Eigen::Index>(floors.size())).colwise().sum().maxCoeff(&best);
  return floors[static_cast<std::size_t>(best)];
}

std::vector<int> Candidates(const Site& site, const Evidence& evidence) {
  if (evidence.floor) return {*evidence.floor};
  const std::vector<int> surveyed = site.SurveyedFloors();
  std::set<int> floors(surveyed.begin(), surveyed.end());
  for (const Floor& floor : site.building.floors) floors.insert(floor.number);
  if (floors.empty()) floors.insert(0);
  return {floors.begin(), floors.end()};
}

}  // namespace

double FloorTrack::ProbabilityAt(int floor, TimeNs time_ns) const {
  const auto column = std::find(floors.begin(), floors.end(), floor);
  if (column == floors.end()) return 0;
  const auto after = std::lower_bound(this->time_ns.begin(), this->time_ns.end(), time_ns);
  auto nearest = after - this->time_ns.begin();
  if (after == this->time_ns.end()) --nearest;
  if (nearest > 0 && time_ns - this->time_ns[nearest - 1] < this->time_ns[nearest] - time_ns) {
    --nearest;
  }
  return probability(nearest, column - floors.begin());
}

FloorTrack TrackFloors(const Site& site, const Evidence& evidence, const FactorSettings& settings,
                       double lag_s) {
  FloorTrack track;
  track.floors = Candidates(site, evidence);
  track.time_ns = Epochs(evidence);
  const auto epochs = static_cast<Eigen::Index>(track.time_ns.size());
  if (track.floors.size() == 1) {
    track.path = track.floors.front();
    track.probability = Eigen::MatrixXd::Ones(epochs, 1);
    return track;
  }
  const FloorSounds sounds(site, settings);
  const FloorModel model(site, evidence, settings, track.floors, sounds.LogPrior(track.floors));
  const std::vector<Belief> likelihoods =
      Likelihoods(model, track.time_ns, sounds.Looks(evidence, track.floors), !std::isinf(lag_s));
  const Eigen::MatrixXd posterior = Smooth(model, likelihoods, lag_s);
  track.path = PathOf(posterior, track.time_ns, track.floors);
  track.probability = posterior.leftCols(static_cast<Eigen::Index>(track.floors.size()));
  return track;
}

}  // namespace walkgraph
