#include "solvers/baselines/floor_tracker.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "frontends/radio_map/barometric_history.h"
#include "solvers/baselines/fixes.h"
#include "solvers/baselines/floor_likelihood.h"

namespace walkgraph {
namespace {

constexpr double kEpochS = 2.0;
// The grid of barometric offsets: fine against the height of a storey, and no more cells than this.
constexpr double kCellM = 0.25;
constexpr int kMostCells = 600;
constexpr double kMarginM = 2.0;  // beyond the heights of the floors
// A pressure that fits no floor: a draught, a mezzanine. As likely as this at any epoch, and
// uniform over kAnywhereM.
constexpr double kOutlierChance = 0.01;
constexpr double kAnywhereM = 20.0;
// Doors and ventilation shift the pressure of a whole house now and then: once in three hours.
constexpr double kJumpsPerS = 1e-4;

// That a phone of a model that the survey knows is another one, or has been reset: our choice.
constexpr double kOtherPhoneChance = 0.05;

// A distribution: a column for each floor and one for "between", a row for each cell of the offset.
using Belief = Eigen::MatrixXd;

class FloorModel {
 public:
  FloorModel(const Site& site, const Evidence& evidence, const FactorSettings& settings,
             std::vector<int> floors, Eigen::VectorXd log_prior)
      : evidence_(evidence),
        settings_(settings),
        offset_prior_(PriorOfOffset(site.barometric_offsets, evidence,
                                    settings.barometric_offset.walk_m_per_sqrt_s)),
        floors_(std::move(floors)),
        log_prior_(std::move(log_prior)) {
    for (const int floor : floors_) heights_m_.push_back(FloorHeight(site, floor));
    lowest_m_ = *std::min_element(heights_m_.begin(), heights_m_.end()) - kMarginM;
    highest_m_ = *std::max_element(heights_m_.begin(), heights_m_.end()) + kMarginM;
    LayOutCells();
  }

  Belief Start() const {
    const double between =
        settings_.floor.change_s / (settings_.floor.change_s + settings_.floor.stay_s);
    Belief belief(cells_, Columns());
    belief.leftCols(Columns() - 1).rowwise() =
        (1 - between) * log_prior_.array().exp().matrix().transpose();
    belief.rightCols(1).setConstant(between);
    belief = (belief.array().colwise() * OffsetPriorOfCells().array()).matrix();
    return belief / belief.sum();
  }

  // One epoch on.
  Belief Predict(const Belief& belief) const { return Mix(Drift(belief), MixMatrix()); }
  // The transpose: what a later epoch's likelihoods say about the one before.
  Belief Retrodict(const Belief& likelihood) const {
    return Drift(Mix(likelihood, MixMatrix().transpose()));
  }

  // Likelihood of an epoch's pressure, up to a factor.
  Belief OfPressure(std::optional<double> height_m) const {
    Belief likelihood = Belief::Ones(cells_, Columns());
    if (!height_m || !measured_) return likelihood;
    const double level = settings_.level.sigma_m, own = settings_.barometric.sigma_m;
    const double variance = level * level + own * own + cell_m_ * cell_m_ / 12.0;
    const double peak = (1 - kOutlierChance) / std::sqrt(2 * std::numbers::pi * variance);
    for (int c = 0; c < cells_; ++c) {
      const double z = *height_m - (first_m_ + c * cell_m_);
      for (std::size_t f = 0; f < floors_.size(); ++f) {
        const double d = z - heights_m_[f];
        likelihood(c, static_cast<Eigen::Index>(f)) =
            peak * std::exp(-0.5 * d * d / variance) + kOutlierChance / kAnywhereM;
      }
      const bool inside = z > lowest_m_ && z < highest_m_;
      likelihood(c, Columns() - 1) =
          inside ? 1.0 / (highest_m_ - lowest_m_) : kOutlierChance / kAnywhereM;
    }
    return likelihood;
  }

  // The barometer's last height at a time, where it still ran.
  std::optional<double> HeightAt(TimeNs time_ns) const {
    const Stream<double>& heights = evidence_.barometric_height_m;
    const auto after = std::upper_bound(heights.time_ns.begin(), heights.time_ns.end(), time_ns);
    if (after == heights.time_ns.begin()) return std::nullopt;
    const auto i = static_cast<std::size_t>(after - heights.time_ns.begin()) - 1;
    if (SecondsBetween(heights.time_ns[i], time_ns) > kEpochS) return std::nullopt;
    return heights.value[i];
  }

  Eigen::Index Columns() const { return static_cast<Eigen::Index>(floors_.size()) + 1; }

 private:
  void LayOutCells() {
    const std::vector<double>& heights = evidence_.barometric_height_m.value;
    const BarometricOffsetSettings& offset = settings_.barometric_offset;
    // A building that does not know the heights of its floors gives pressure nothing to go by.
    const bool known = std::set<double>(heights_m_.begin(), heights_m_.end()).size() > 1;
    measured_ = settings_.barometric.enabled && !heights.empty() && known;
    if (!measured_) return;
    if (offset.mode != StateMode::kActive) {  // one cell: it is known
      first_m_ = offset.mode == StateMode::kFixed ? offset.prior_mean_m : 0.0;
      return;
    }
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    first_m_ = *low - highest_m_;
    const double span_m = (*high - lowest_m_) - first_m_;
    cell_m_ = std::max(kCellM, span_m / kMostCells);
    cells_ = static_cast<int>(std::ceil(span_m / cell_m_)) + 1;
  }

  // Without a history of the phone's offset any is as likely.
  Eigen::VectorXd OffsetPriorOfCells() const {
    Eigen::VectorXd prior = Eigen::VectorXd::Ones(cells_);
    if (!offset_prior_ || cells_ == 1) return prior;
    const double variance = offset_prior_->sigma_m * offset_prior_->sigma_m +
                            settings_.level.sigma_m * settings_.level.sigma_m +
                            cell_m_ * cell_m_ / 12.0;
    for (int c = 0; c < cells_; ++c) {
      const double d = first_m_ + c * cell_m_ - offset_prior_->mean_m;
      prior[c] = std::exp(-0.5 * d * d / variance);
    }
    // Off the grid it would be another phone's for certain.
    const double sum = prior.sum();
    if (!(sum > 0)) return Eigen::VectorXd::Ones(cells_);
    return (1 - kOtherPhoneChance) * prior / sum +
           Eigen::VectorXd::Constant(cells_, kOtherPhoneChance / cells_);
  }

  // The random walk of the offset by one cell at most, and its jumps. Symmetric.
  Belief Drift(const Belief& belief) const {
    if (cells_ == 1) return belief;
    const double rate = settings_.barometric_offset.walk_m_per_sqrt_s;
    const double move = std::min(1.0 / 3, 0.5 * rate * rate * kEpochS / (cell_m_ * cell_m_));
    Belief moved = (1 - 2 * move) * belief;
    moved.bottomRows(cells_ - 1) += move * belief.topRows(cells_ - 1);
    moved.topRows(cells_ - 1) += move * belief.bottomRows(cells_ - 1);
    moved.row(0) += move * belief.row(0);
    moved.row(cells_ - 1) += move * belief.row(cells_ - 1);
    const double jump = kJumpsPerS * kEpochS;
    const Eigen::RowVectorXd anywhere = belief.colwise().mean();
    return ((1 - jump) * moved).rowwise() + jump * anywhere;
  }

  // From column to row: floors are left once in stay_s, the way between them ends after change_s
  // on any.
  Eigen::MatrixXd MixMatrix() const {
    const Eigen::Index between = Columns() - 1;
    const double leave = std::min(0.5, kEpochS / settings_.floor.stay_s);
    const double arrive = std::min(0.5, kEpochS / settings_.floor.change_s);
    Eigen::MatrixXd mix = Eigen::MatrixXd::Zero(Columns(), Columns());
    mix.diagonal().setConstant(1 - leave);
    mix.row(between).setConstant(leave);
    mix.col(between).setConstant(arrive / static_cast<double>(between));
    mix(between, between) = 1 - arrive;
    return mix;
  }

  static Belief Mix(const Belief& belief, const Eigen::MatrixXd& mix) {
    return belief * mix.transpose();
  }

  const Evidence& evidence_;
  const FactorSettings& settings_;
  std::optional<OffsetPrior> offset_prior_;
  std::vector<int> floors_;
  Eigen::VectorXd log_prior_;  // by floor
  std::vector<double> heights_m_;
  double lowest_m_ = 0, highest_m_ = 0;
  double first_m_ = 0, cell_m_ = kCellM;
  int cells_ = 1;
  bool measured_ = false;  // a barometer takes part
};

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
