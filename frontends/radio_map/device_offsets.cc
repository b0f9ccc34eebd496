#include "frontends/radio_map/device_offsets.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace walkgraph {
namespace {

// Transmitter, floor, and column and row of the square.
using Square = std::tuple<std::uint32_t, int, long, long>;

struct WalkMean {
  double sum_dbm = 0, count = 0;
  double Mean() const { return sum_dbm / count; }
};

using MeansByWalk = std::map<std::uint32_t, WalkMean>;

std::map<Square, MeansByWalk> GatherMeans(const std::vector<SurveyScan>& scans, Radio radio,
                                          double square_m) {
  std::map<Square, MeansByWalk> means;
  for (const SurveyScan& scan : scans) {
    if (scan.radio != radio) continue;
    for (const SurveyReading& reading : scan.readings) {
      const Eigen::Vector2d at = reading.position_m.cast<double>() / square_m;
      WalkMean& mean = means[{reading.transmitter, scan.floor, std::lround(at.x()),
                              std::lround(at.y())}][scan.walk];
      mean.sum_dbm += reading.rssi_dbm;
      ++mean.count;
    }
  }
  return means;
}

// The normal equations of the offsets once the squares' levels are eliminated.
struct LevelledEquations {
  Eigen::MatrixXd information;  // walks x walks, for noise of variance 1
  Eigen::VectorXd right;
  double sum_of_squares = 0;  // about the squares' levels
  double contrasts = 0;       // means that a square has beyond its first
};

LevelledEquations EliminateLevels(const std::map<Square, MeansByWalk>& squares, std::size_t walks) {
  const auto n = static_cast<Eigen::Index>(walks);
  LevelledEquations equations{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
  for (const auto& [square, means] : squares) {
    if (means.size() < 2) continue;
    const auto count = static_cast<double>(means.size());
    double level = 0;
    for (const auto& [walk, mean] : means) level += mean.Mean() / count;
    for (const auto& [walk, mean] : means) {
      const double residual = mean.Mean() - level;
      equations.right[walk] += residual;
      equations.sum_of_squares += residual * residual;
      equations.information(walk, walk) += 1;
      for (const auto& [other, unused] : means) equations.information(walk, other) -= 1 / count;
    }
    equations.contrasts += count - 1;
  }
  return equations;
}

// The restricted likelihood as a function of the variance of offsets over that of the noise alone,
// whose own variance is the best for each ratio. In the eigenvectors of the information.
class VarianceRatio {
 public:
  VarianceRatio(const Eigen::VectorXd& eigenvalues, const Eigen::VectorXd& right,
                const LevelledEquations& equations)
      : eigenvalues_(eigenvalues.cwiseMax(0)), right_(right), equations_(equations) {}

  Eigen::VectorXd Offsets(double ratio) const {
    return ratio * right_.array() / (1 + ratio * eigenvalues_.array());
  }

  double NoiseVariance(double ratio) const {
    const double explained = right_.dot(Offsets(ratio));
    return std::max(1e-12, equations_.sum_of_squares - explained) / equations_.contrasts;
  }

  double Best() const {
    double best = 0;
    double least = MinusTwoLogLikelihood(0);
    for (double log10_ratio = -4; log10_ratio <= 3; log10_ratio += 0.02) {
      const double ratio = std::pow(10, log10_ratio);
      const double value = MinusTwoLogLikelihood(ratio);
      if (value < least) std::tie(best, least) = std::pair(ratio, value);
    }
    return best;
  }

 private:
  double MinusTwoLogLikelihood(double ratio) const {
    return equations_.contrasts * std::log(NoiseVariance(ratio)) +
           (ratio * eigenvalues_.array()).log1p().sum();
  }

  Eigen::VectorXd eigenvalues_, right_;
  const LevelledEquations& equations_;
};

}  // namespace

DeviceOffsets EstimateDeviceOffsets(const std::vector<SurveyScan>& scans, Radio radio,
                                    double square_m) {
  DeviceOffsets offsets;
  std::size_t walks = 0;
  for (const SurveyScan& scan : scans) walks = std::max<std::size_t>(walks, scan.walk + 1);
  offsets.offset_db.assign(walks, 0.0);
  const LevelledEquations equations = EliminateLevels(GatherMeans(scans, radio, square_m), walks);
  if (equations.contrasts <= 0) return offsets;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(equations.information);
  const VarianceRatio ratios(eigen.eigenvalues(),
                             eigen.eigenvectors().transpose() * equations.right, equations);
  const double ratio = ratios.Best();
  Eigen::Map<Eigen::VectorXd>(offsets.offset_db.data(), static_cast<Eigen::Index>(walks)) =
      eigen.eigenvectors() * ratios.Offsets(ratio);
  offsets.reading_sigma_db = std::sqrt(ratios.NoiseVariance(ratio));
  offsets.spread_db = std::sqrt(ratio) * offsets.reading_sigma_db;
  return offsets;
}

void SetPhoneOffsets(double square_m, std::vector<SurveyScan>* scans) {
  for (const Radio radio : kAllRadios) {
    const DeviceOffsets offsets = EstimateDeviceOffsets(*scans, radio, square_m);
    for (SurveyScan& scan : *scans) {
      if (scan.radio != radio) continue;
      scan.phone_offset_db = static_cast<float>(offsets.offset_db[scan.walk]);
    }
  }
}

}  // namespace walkgraph
