#include "frontends/radio_map/magnetic_trainer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace walkgraph {
namespace {

constexpr double kGridM = 1.0;       // of the control points: steel bends the field over metres
constexpr double kMergeM = 0.5;      // samples of one walk closer than this become one
constexpr double kReach = 3.0;       // bandwidths beyond which a kernel is nothing
constexpr double kMinSigmaUt = 0.3;  // resolution of phones' magnetometers
constexpr double kMaxLagS = 60.0;    // of the autocorrelation
constexpr double kUncorrelated = 0.05;
constexpr std::size_t kMinTrials = 3;
constexpr std::size_t kLeftOutSamples = 3000;  // the model is chosen on; more change no choice
constexpr std::array<double, 5> kBandwidthsM = {0.7, 1.0, 1.5, 2.5, 4.0};
constexpr std::array<double, 4> kPriorWeights = {0.03, 0.1, 0.3, 1.0};

struct Sample {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d field_ut = Eigen::Vector2d::Zero();
  std::uint32_t walk = 0;
  std::uint32_t trial = 0;
};

struct Density {
  Eigen::Array2d mean_ut = Eigen::Array2d::Zero();
  Eigen::Array2d variance_ut2 = Eigen::Array2d::Zero();
};

struct KernelModel {
  double bandwidth_m = 1;
  double prior_weight = 0.1;
};

std::vector<Sample> SamplesOf(const Site& site, int floor) {
  std::vector<Sample> samples;
  for (const SurveyMagnetic& s : site.magnetic) {
    if (s.floor != floor) continue;
    samples.push_back({s.position_m.cast<double>(),
                       MagneticComponents({s.norm_ut, s.inclination_rad}), s.walk, s.trial});
  }
  return samples;
}

// A person who stands still measures one place once, however long.
std::vector<Sample> Merge(const std::vector<Sample>& samples) {
  std::map<std::tuple<std::uint32_t, long, long>, std::pair<Sample, int>> cells;
  for (const Sample& sample : samples) {
    const Eigen::Vector2d cell = sample.position_m / kMergeM;
    auto& [sum, count] = cells[{sample.walk, std::lround(cell.x()), std::lround(cell.y())}];
    sum.position_m += sample.position_m;
    sum.field_ut += sample.field_ut;
    sum.walk = sample.walk;
    sum.trial = sample.trial;
    ++count;
  }
  std::vector<Sample> merged;
  for (auto& [key, cell] : cells) {
    cell.first.position_m /= cell.second;
    cell.first.field_ut /= cell.second;
    merged.push_back(cell.first);
  }
  return merged;
}

// Kernel estimates of the field from samples, found through squares of a fixed size.
class KernelField {
 public:
  explicit KernelField(std::vector<Sample> samples) : samples_(std::move(samples)) {
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      squares_[SquareOf(samples_[i].position_m)].push_back(i);
      floor_.mean_ut += samples_[i].field_ut.array();
    }
    floor_.mean_ut /= static_cast<double>(samples_.size());
    for (const Sample& sample : samples_) {
      floor_.variance_ut2 += (sample.field_ut.array() - floor_.mean_ut).square();
    }
    floor_.variance_ut2 /= static_cast<double>(samples_.size());
    floor_.variance_ut2 = floor_.variance_ut2.max(kMinSigmaUt * kMinSigmaUt);
  }

  const std::vector<Sample>& samples() const { return samples_; }
  const Density& floor() const { return floor_; }

  // The field at a place, from all samples or from all but those of one trial.
  Density At(const Eigen::Vector2d& place, const KernelModel& model,
             std::optional<std::uint32_t> left_out = std::nullopt) const {
    const double reach_m = kReach * model.bandwidth_m;
    const double scale = -0.5 / (model.bandwidth_m * model.bandwidth_m);
    // Deviations from the floor's mean: the pseudo-sample has none.
    double weight = model.prior_weight;
    Eigen::Array2d sum = Eigen::Array2d::Zero();
    Eigen::Array2d squares = model.prior_weight * floor_.variance_ut2;
    const Square first = SquareOf(place.array() - reach_m),
                 last = SquareOf(place.array() + reach_m);
    for (long x = first.first; x <= last.first; ++x) {
      for (long y = first.second; y <= last.second; ++y) {
        const auto found = squares_.find({x, y});
        if (found == squares_.end()) continue;
        for (const std::size_t i : found->second) {
          const Sample& sample = samples_[i];
          const double squared_m2 = (sample.position_m - place).squaredNorm();
          if (squared_m2 > reach_m * reach_m || sample.trial == left_out) continue;
          const double kernel = std::exp(scale * squared_m2);
          const Eigen::Array2d deviation = sample.field_ut.array() - floor_.mean_ut;
          weight += kernel;
          sum += kernel * deviation;
          squares += kernel * deviation.square();
        }
      }
    }
    const Eigen::Array2d mean = sum / weight;
    return {floor_.mean_ut + mean,
            (squares / weight - mean.square()).max(kMinSigmaUt * kMinSigmaUt)};
  }

 private:
  using Square = std::pair<long, long>;
  static constexpr double kSquareM = 2.0;
  static Square SquareOf(const Eigen::Vector2d& place) {
    return {static_cast<long>(std::floor(place.x() / kSquareM)),
            static_cast<long>(std::floor(place.y() / kSquareM))};
  }

  std::vector<Sample> samples_;
  std::map<Square, std::vector<std::size_t>> squares_;
  Density floor_;
};

Eigen::Array2d Whitened(const Sample& sample, const Density& density) {
  return (sample.field_ut.array() - density.mean_ut) / density.variance_ut2.sqrt();
}

double LeftOutLogDensity(const KernelField& field, const KernelModel& model) {
  const std::vector<Sample>& samples = field.samples();
  const std::size_t step = std::max<std::size_t>(1, samples.size() / kLeftOutSamples);
  double sum = 0;
  for (std::size_t i = 0; i < samples.size(); i += step) {
    const Density density = field.At(samples[i].position_m, model, samples[i].trial);
    sum -= 0.5 * (Whitened(samples[i], density).square() + density.variance_ut2.log()).sum();
  }
  return sum;
}

KernelModel SelectModel(const KernelField& field) {
  KernelModel best;
  double best_density = -std::numeric_limits<double>::infinity();
  for (const double bandwidth_m : kBandwidthsM) {
    for (const double prior_weight : kPriorWeights) {
      const KernelModel model{bandwidth_m, prior_weight};
      const double density = LeftOutLogDensity(field, model);
      if (density <= best_density) continue;
      best_density = density;
      best = model;
    }
  }
  return best;
}

// Sums of products of left-out residuals by the number of samples between them.
struct Autocorrelation {
  Autocorrelation() : products(static_cast<std::size_t>(kMaxLagS / kMagneticSampleS)) {}
  std::vector<double> products;

  void Add(const std::vector<Eigen::Array2d>& residuals) {
    for (std::size_t lag = 0; lag < products.size(); ++lag) {
      for (std::size_t i = 0; i + lag < residuals.size(); ++i) {
        products[lag] += (residuals[i] * residuals[i + lag]).sum();
      }
    }
  }

  // Samples that are worth one: 1 + 2 sum of correlations, up to the first that is none.
  double IntegratedSamples() const {
    double sum = 1;
    for (std::size_t lag = 1; lag < products.size(); ++lag) {
      const double correlation = products[lag] / products[0];
      if (correlation < kUncorrelated) break;
      sum += 2 * correlation;
    }
    return sum;
  }
};

struct Calibration {
  Eigen::Array2d sigma_scale = Eigen::Array2d::Ones();
  double correlation_s = kMagneticSampleS;
};

Calibration Calibrate(const KernelField& field, const KernelModel& model,
                      const std::vector<Sample>& samples) {
  Autocorrelation correlation;
  Eigen::Array2d squares = Eigen::Array2d::Zero();
  std::vector<Eigen::Array2d> walk;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Density density = field.At(samples[i].position_m, model, samples[i].trial);
    walk.push_back(Whitened(samples[i], density));
    squares += walk.back().square();
    if (i + 1 < samples.size() && samples[i + 1].walk == samples[i].walk) continue;
    correlation.Add(walk);
    walk.clear();
  }
  Calibration result;
  result.sigma_scale = (squares / static_cast<double>(samples.size())).sqrt();
  result.correlation_s = kMagneticSampleS * correlation.IntegratedSamples();
  return result;
}

// Covers the samples and their kernels, with two control points beyond on every side.
FieldGrid GridAround(const std::vector<Sample>& samples, double reach_m) {
  Eigen::Vector2d low = samples.front().position_m, high = low;
  for (const Sample& sample : samples) {
    low = low.cwiseMin(sample.position_m);
    high = high.cwiseMax(sample.position_m);
  }
  FieldGrid grid;
  grid.spacing_m = kGridM;
  grid.origin_m = low.array() - reach_m - 2 * kGridM;
  const Eigen::Array2d size = (high - low).array() + 2 * reach_m;
  grid.columns = static_cast<int>(std::ceil(size.x() / kGridM)) + 5;
  grid.rows = static_cast<int>(std::ceil(size.y() / kGridM)) + 5;
  return grid;
}

MagneticMap BuildMap(int floor, const KernelField& field, const KernelModel& model,
                     const Calibration& calibration) {
  MagneticMap map;
  map.floor = floor;
  map.grid = GridAround(field.samples(), kReach * model.bandwidth_m);
  map.correlation_s = calibration.correlation_s;
  float min_log_sigma = std::numeric_limits<float>::infinity();
  for (int row = 0; row < map.grid.rows; ++row) {
    for (int column = 0; column < map.grid.columns; ++column) {
      const Density density =
          field.At(map.grid.origin_m + kGridM * Eigen::Vector2d(column, row), model);
      for (int c = 0; c < 2; ++c) {
        MagneticMap::Component& component = map.components[static_cast<std::size_t>(c)];
        component.mean_ut.push_back(static_cast<float>(density.mean_ut[c]));
        const double sigma = calibration.sigma_scale[c] * std::sqrt(density.variance_ut2[c]);
        component.log_sigma.push_back(static_cast<float>(std::log(sigma)));
        min_log_sigma = std::min(min_log_sigma, component.log_sigma.back());
      }
    }
  }
  map.sigma_min_ut = std::exp(static_cast<double>(min_log_sigma));
  return map;
}

std::optional<MagneticMap> TrainMap(const Site& site, int floor) {
  const std::vector<Sample> samples = SamplesOf(site, floor);
  std::set<std::uint32_t> trials;
  for (const Sample& sample : samples) trials.insert(sample.trial);
  if (trials.size() < kMinTrials) return std::nullopt;
  const KernelField field(Merge(samples));
  const KernelModel model = SelectModel(field);
  return BuildMap(floor, field, model, Calibrate(field, model, samples));
}

}  // namespace

std::vector<MagneticMap> TrainMagneticMaps(const Site& site) {
  std::set<int> floors;
  for (const SurveyMagnetic& sample : site.magnetic) floors.insert(sample.floor);
  std::vector<MagneticMap> maps;
  for (const int floor : floors) {
    if (std::optional<MagneticMap> map = TrainMap(site, floor)) maps.push_back(std::move(*map));
  }
  return maps;
}

}  // namespace walkgraph
