#include "solvers/baselines/hipe_emission.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace walkgraph {
namespace {

constexpr double kFallbackSdDb = 5;  // where no point has two readings of one access point

// The survey's Wi-Fi readings on a floor by transmitter, and how many scans each point was near.
struct Training {
  std::vector<std::vector<SurveyReading>> readings;
  std::vector<double> scans;
};

Training CollectTraining(const Site& site, int floor, const ReferencePoints& points,
                         double max_age_s, double radius_m) {
  Training training{std::vector<std::vector<SurveyReading>>(site.transmitters.size()),
                    std::vector<double>(points.size(), 0.0)};
  for (const SurveyScan& scan : site.scans) {
    if (scan.radio != Radio::kWifi || scan.floor != floor) continue;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double count = 0;
    for (const SurveyReading& reading : scan.readings) {
      if (reading.age_s >= max_age_s) continue;
      training.readings[reading.transmitter].push_back(reading);
      sum += reading.position_m.cast<double>();
      ++count;
    }
    if (count == 0) continue;
    points.ForNear(sum / count, radius_m,
                   [&](int point) { ++training.scans[static_cast<std::size_t>(point)]; });
  }
  return training;
}

// Power sums about a level in the middle of all signals: the moments lose nothing by it.
struct PowerSums {
  static constexpr double kLevelDbm = -70;
  double count = 0, first = 0, second = 0, third = 0;

  void Add(double rssi_dbm) {
    const double d = rssi_dbm - kLevelDbm;
    ++count;
    first += d;
    second += d * d;
    third += d * d * d;
  }
};

// What the floor as a whole says about spread and skewness around the means of the points.
class Pool {
 public:
  void Add(double count, double squares_db2, double cubes_db3) {
    squares_db2_ += squares_db2;
    degrees_of_freedom_ += count - 1;
    if (count < 3) return;
    // count times the unbiased third central moment
    third_db3_ += count * count / ((count - 1) * (count - 2)) * cubes_db3;
    third_weight_ += count;
  }
  double SdDb() const {
    if (!(degrees_of_freedom_ > 0) || !(squares_db2_ > 0)) return kFallbackSdDb;
    return std::sqrt(squares_db2_ / degrees_of_freedom_);
  }
  double Skewness() const {
    const double sd = SdDb();
    return third_weight_ > 0 ? third_db3_ / third_weight_ / (sd * sd * sd) : 0.0;
  }

 private:
  double squares_db2_ = 0, degrees_of_freedom_ = 0, third_db3_ = 0, third_weight_ = 0;
};

}  // namespace

// The readings of one access point near one reference point.
struct HipeEmission::Cell {
  int point = 0;
  double count = 0;
  double mean_dbm = 0;
  double squares_db2 = 0;  // sum of squared deviations from the mean
  double hear_probability = 0;
};

HipeEmission::HipeEmission(const Site& site, int floor, const ReferencePoints& points,
                           const std::vector<std::uint32_t>& wanted, double max_age_s,
                           const HipeEmissionSettings& settings)
    : settings_(settings), log_silence_(points.size(), 0.0), densities_(site.transmitters.size()) {
  const double radius_m = settings.training_radius_m;
  const Training training = CollectTraining(site, floor, points, max_age_s, radius_m);
  Pool pool;
  std::vector<std::vector<Cell>> cells(site.transmitters.size());
  std::vector<PowerSums> sums(points.size());
  for (std::size_t t = 0; t < cells.size(); ++t) {
    std::vector<int> touched;
    for (const SurveyReading& reading : training.readings[t]) {
      points.ForNear(reading.position_m.cast<double>(), radius_m, [&](int point) {
        PowerSums& sum = sums[static_cast<std::size_t>(point)];
        if (sum.count == 0) touched.push_back(point);
        sum.Add(reading.rssi_dbm);
      });
    }
    std::sort(touched.begin(), touched.end());
    for (const int point : touched) {
      const auto at = static_cast<std::size_t>(point);
      const PowerSums sum = std::exchange(sums[at], {});
      const double mean = sum.first / sum.count;
      const double squares = std::max(0.0, sum.second - sum.first * mean);
      pool.Add(sum.count, squares, sum.third - 3 * mean * sum.second + 2 * mean * mean * sum.first);
      // Krichevsky and Trofimov's prior keeps a rate off 0 and 1.
      const double hear = (sum.count + 0.5) / (std::max(sum.count, training.scans[at]) + 1);
      cells[t].push_back({point, sum.count, PowerSums::kLevelDbm + mean, squares, hear});
      if (settings.use_silence) log_silence_[at] += std::log1p(-hear);
    }
  }
  pooled_sd_db_ = pool.SdDb();
  shape_ = settings.weibull_shape > 0 ? settings.weibull_shape : WeibullShape(pool.Skewness());
  for (const std::uint32_t t : wanted) densities_[t] = MakeDensities(cells[t]);
}

std::vector<HipeEmission::Density> HipeEmission::MakeDensities(
    const std::vector<Cell>& cells) const {
  const double pooled_variance = pooled_sd_db_ * pooled_sd_db_;
  std::vector<Density> densities;
  for (const Cell& cell : cells) {
    const double variance = (settings_.prior_readings * pooled_variance + cell.squares_db2) /
                            (settings_.prior_readings + cell.count - 1);
    // The mean of few readings is itself uncertain.
    const double sd_db = std::sqrt(variance * (1 + 1 / cell.count));
    Density density;
    density.point = cell.point;
    density.weibull = WeibullFromMoments(shape_, cell.mean_dbm, sd_db);
    density.log_odds_heard = std::log(cell.hear_probability / (1 - cell.hear_probability));
    densities.push_back(density);
  }
  return densities;
}

std::vector<double> HipeEmission::LogLikelihood(const SignalVector& scan) const {
  const double log_floor = std::log(settings_.floor_probability);
  std::vector<double> sum = log_silence_;
  for (const SignalVector::Entry& entry : scan.entries) {
    for (double& value : sum) value += log_floor;
    for (const Density& density : densities_[entry.transmitter]) {
      const double probability =
          std::max(settings_.floor_probability, BinProbability(density.weibull, entry.rssi_dbm));
      double& value = sum[static_cast<std::size_t>(density.point)];
      value += std::log(probability) - log_floor;
      if (settings_.use_silence) value += density.log_odds_heard;
    }
  }
  return sum;
}

}  // namespace walkgraph
