#include "solvers/baselines/floor_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <utility>

#include "solvers/baselines/fixes.h"

namespace walkgraph {
namespace {

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

FloorModel::Belief Mix(const FloorModel::Belief& belief, const Eigen::MatrixXd& mix) {
  return belief * mix.transpose();
}

}  // namespace

FloorModel::FloorModel(const Site& site, const Evidence& evidence, const FactorSettings& settings,
                       std::vector<int> floors, Eigen::VectorXd log_prior)
    : evidence_(evidence),
      settings_(settings),
      offset_prior_(PriorOfOffset(site.barometric_offsets, evidence,
                                  settings.barometric_offset.walk_m_per_sqrt_s)),
      floors_(std::move(floors)),
      log_prior_(std::move(log_prior)),
      cell_m_(kCellM) {
  for (const int floor : floors_) heights_m_.push_back(FloorHeight(site, floor));
  lowest_m_ = *std::min_element(heights_m_.begin(), heights_m_.end()) - kMarginM;
  highest_m_ = *std::max_element(heights_m_.begin(), heights_m_.end()) + kMarginM;
  LayOutCells();
}

FloorModel::Belief FloorModel::Start() const {
  const double between =
      settings_.floor.change_s / (settings_.floor.change_s + settings_.floor.stay_s);
  Belief belief(cells_, Columns());
  belief.leftCols(Columns() - 1).rowwise() =
      (1 - between) * log_prior_.array().exp().matrix().transpose();
  belief.rightCols(1).setConstant(between);
  belief = (belief.array().colwise() * OffsetPriorOfCells().array()).matrix();
  return belief / belief.sum();
}

FloorModel::Belief FloorModel::Predict(const Belief& belief) const {
  return Mix(Drift(belief), MixMatrix());
}

FloorModel::Belief FloorModel::Retrodict(const Belief& likelihood) const {
  return Drift(Mix(likelihood, MixMatrix().transpose()));
}

FloorModel::Belief FloorModel::OfPressure(std::optional<double> height_m) const {
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

std::optional<double> FloorModel::HeightAt(TimeNs time_ns) const {
  const Stream<double>& heights = evidence_.barometric_height_m;
  const auto after = std::upper_bound(heights.time_ns.begin(), heights.time_ns.end(), time_ns);
  if (after == heights.time_ns.begin()) return std::nullopt;
  const auto i = static_cast<std::size_t>(after - heights.time_ns.begin()) - 1;
  if (SecondsBetween(heights.time_ns[i], time_ns) > kEpochS) return std::nullopt;
  return heights.value[i];
}

void FloorModel::LayOutCells() {
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
Eigen::VectorXd FloorModel::OffsetPriorOfCells() const {
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
FloorModel::Belief FloorModel::Drift(const Belief& belief) const {
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
Eigen::MatrixXd FloorModel::MixMatrix() const {
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

}  // namespace walkgraph
