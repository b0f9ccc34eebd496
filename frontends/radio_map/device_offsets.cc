#include "frontends/radio_map/device_offsets.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace walkgraph {
namespace {

// The eigenvectors of more walks would take minutes; an even selection of them tells the variances.
constexpr std::size_t kMostWalksForVariances = 1000;

// What a walk heard of a transmitter in one square, on average.
struct WalkMean {
  std::uint32_t walk = 0;
  double rssi_dbm = 0;
};

// The walks that heard one transmitter in one square, two at least.
using SharedSquare = std::vector<WalkMean>;

std::vector<SharedSquare> FindSharedSquares(const std::vector<SurveyScan>& scans, Radio radio,
                                            double square_m) {
  using Square = std::tuple<std::uint32_t, int, long, long>;  // transmitter, floor, column, row
  std::map<Square, std::map<std::uint32_t, std::pair<double, double>>> sums;
  for (const SurveyScan& scan : scans) {
    if (scan.radio != radio) continue;
    for (const SurveyReading& reading : scan.readings) {
      const Eigen::Vector2d at = reading.position_m.cast<double>() / square_m;
      auto& [sum, count] = sums[{reading.transmitter, scan.floor, std::lround(at.x()),
                                 std::lround(at.y())}][scan.walk];
      sum += double{reading.rssi_dbm} - reading.shadow_db;
      ++count;
    }
  }
  std::vector<SharedSquare> shared;
  for (const auto& [square, walks] : sums) {
    if (walks.size() < 2) continue;
    SharedSquare& means = shared.emplace_back();
    for (const auto& [walk, sum] : walks) means.push_back({walk, sum.first / sum.second});
  }
  return shared;
}

// Every `stride`-th walk, renumbered.
std::vector<SharedSquare> SelectWalks(const std::vector<SharedSquare>& squares,
                                      std::size_t stride) {
  std::vector<SharedSquare> selected;
  for (const SharedSquare& square : squares) {
    SharedSquare kept;
    for (const WalkMean& mean : square) {
      if (mean.walk % stride != 0) continue;
      kept.push_back({static_cast<std::uint32_t>(mean.walk / stride), mean.rssi_dbm});
    }
    if (kept.size() >= 2) selected.push_back(std::move(kept));
  }
  return selected;
}

// Subtracts from the values of a square's walks their mean, which eliminates its level.
template <typename Visitor>
void VisitDeviations(const SharedSquare& square, Visitor&& visit) {
  double level = 0;
  for (const WalkMean& mean : square) level += mean.rssi_dbm / static_cast<double>(square.size());
  for (const WalkMean& mean : square) visit(mean.walk, mean.rssi_dbm - level);
}

// The right side of the offsets' normal equations, for noise of variance 1.
Eigen::VectorXd RightSide(const std::vector<SharedSquare>& squares, std::size_t walks) {
  Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(walks));
  for (const SharedSquare& square : squares) {
    VisitDeviations(square,
                    [&](std::uint32_t walk, double deviation_db) { right[walk] += deviation_db; });
  }
  return right;
}

// Their matrix times x.
Eigen::VectorXd InformationTimes(const std::vector<SharedSquare>& squares,
                                 const Eigen::VectorXd& x) {
  Eigen::VectorXd product = Eigen::VectorXd::Zero(x.size());
  for (const SharedSquare& square : squares) {
    double mean = 0;
    for (const WalkMean& walk : square) mean += x[walk.walk] / static_cast<double>(square.size());
    for (const WalkMean& walk : square) product[walk.walk] += x[walk.walk] - mean;
  }
  return product;
}

// Their matrix itself.
Eigen::MatrixXd Information(const std::vector<SharedSquare>& squares, std::size_t walks) {
  const auto n = static_cast<Eigen::Index>(walks);
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(n, n);
  for (const SharedSquare& square : squares) {
    for (const WalkMean& a : square) {
      information(a.walk, a.walk) += 1;
      for (const WalkMean& b : square) {
        information(a.walk, b.walk) -= 1 / static_cast<double>(square.size());
      }
    }
  }
  return information;
}

struct Variances {
  double ratio = 0;           // of the offsets' variance over that of the noise
  double noise_variance = 0;  // dB^2
};

// Maximises the restricted likelihood over the ratio; the noise is the best for each ratio.
Variances BestVariances(const std::vector<SharedSquare>& squares, std::size_t walks) {
  double sum_of_squares = 0, contrasts = 0;
  for (const SharedSquare& square : squares) {
    VisitDeviations(square, [&](std::uint32_t, double deviation_db) {
      sum_of_squares += deviation_db * deviation_db;
    });
    contrasts += static_cast<double>(square.size()) - 1;
  }
  if (contrasts <= 0) return {};
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(Information(squares, walks));
  const Eigen::ArrayXd eigenvalues = eigen.eigenvalues().cwiseMax(0);
  const Eigen::ArrayXd right = eigen.eigenvectors().transpose() * RightSide(squares, walks);
  Variances best;
  double least = std::numeric_limits<double>::infinity();
  const auto try_ratio = [&](double ratio) {
    const Eigen::ArrayXd spread = 1 + ratio * eigenvalues;
    const double explained = (ratio * right.square() / spread).sum();
    const double noise_variance = std::max(1e-12, sum_of_squares - explained) / contrasts;
    const double cost = contrasts * std::log(noise_variance) + spread.log().sum();
    if (cost < least) {
      least = cost;
      best = {ratio, noise_variance};
    }
  };
  try_ratio(0);
  for (int step = -200; step <= 150; ++step) try_ratio(std::pow(10, step / 50.0));
  return best;
}

// Conjugate gradients on the normal equations with the prior that the ratio makes.
Eigen::VectorXd SolveOffsets(const std::vector<SharedSquare>& squares, std::size_t walks,
                             double ratio) {
  const Eigen::VectorXd right = RightSide(squares, walks);
  Eigen::VectorXd offsets = Eigen::VectorXd::Zero(right.size());
  Eigen::VectorXd residual = right, direction = right;
  for (std::size_t i = 0; i < 2 * walks && residual.norm() > 1e-10 * right.norm(); ++i) {
    const Eigen::VectorXd image = InformationTimes(squares, direction) + direction / ratio;
    const double before = residual.squaredNorm();
    const double step = before / direction.dot(image);
    offsets += step * direction;
    residual -= step * image;
    direction = residual + residual.squaredNorm() / before * direction;
  }
  return offsets;
}

double Mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Offsets of the walks that heard the radio.
std::map<std::string, std::vector<double>> OffsetsByDevice(
    const std::vector<SurveyScan>& scans, Radio radio,
    const std::vector<std::string>& device_of_walk) {
  std::map<std::uint32_t, double> of_walk;
  for (const SurveyScan& scan : scans) {
    if (scan.radio == radio) of_walk[scan.walk] = scan.device_offset_db;
  }
  std::map<std::string, std::vector<double>> by_device;
  for (const auto& [walk, offset_db] : of_walk) {
    by_device[device_of_walk[walk]].push_back(offset_db);
  }
  return by_device;
}

// Of the walks of a model about its mean, dB^2; none where the walks do not tell.
std::optional<double> VarianceWithin(const std::map<std::string, std::vector<double>>& by_device) {
  constexpr std::size_t kFewestContrasts = 3;
  double squares = 0;
  std::size_t contrasts = 0;
  for (const auto& [device, offsets] : by_device) {
    const double mean = Mean(offsets);
    for (const double offset : offsets) squares += (offset - mean) * (offset - mean);
    contrasts += offsets.size() - 1;
  }
  if (contrasts < kFewestContrasts || squares <= 0) return std::nullopt;
  return squares / static_cast<double>(contrasts);
}

}  // namespace

DeviceOffsets EstimateDeviceOffsets(const std::vector<SurveyScan>& scans, Radio radio,
                                    double square_m) {
  DeviceOffsets offsets;
  std::size_t walks = 0;
  for (const SurveyScan& scan : scans) walks = std::max<std::size_t>(walks, scan.walk + 1);
  offsets.offset_db.assign(walks, 0.0);
  const std::vector<SharedSquare> squares = FindSharedSquares(scans, radio, square_m);
  const std::size_t stride = walks / kMostWalksForVariances + 1;
  const Variances variances = BestVariances(SelectWalks(squares, stride), walks / stride + 1);
  offsets.reading_sigma_db = std::sqrt(variances.noise_variance);
  offsets.spread_db = std::sqrt(variances.ratio) * offsets.reading_sigma_db;
  if (variances.ratio > 0) {
    const Eigen::VectorXd solution = SolveOffsets(squares, walks, variances.ratio);
    offsets.offset_db.assign(solution.begin(), solution.end());
  }
  return offsets;
}

void SetDeviceOffsets(double square_m, std::vector<SurveyScan>* scans) {
  for (const Radio radio : kAllRadios) {
    const DeviceOffsets offsets = EstimateDeviceOffsets(*scans, radio, square_m);
    for (SurveyScan& scan : *scans) {
      if (scan.radio != radio) continue;
      scan.device_offset_db = static_cast<float>(offsets.offset_db[scan.walk]);
    }
  }
}

std::vector<DeviceLoudness> SummariseDevices(const std::vector<SurveyScan>& scans,
                                             const std::vector<std::string>& device_of_walk) {
  std::vector<DeviceLoudness> summary;
  for (const Radio radio : kAllRadios) {
    const std::map<std::string, std::vector<double>> by_device =
        OffsetsByDevice(scans, radio, device_of_walk);
    const std::optional<double> variance = VarianceWithin(by_device);
    if (!variance) continue;
    for (const auto& [device, offsets] : by_device) {
      const double more = 1 + 1 / static_cast<double>(offsets.size());
      summary.push_back({device, radio, Mean(offsets), std::sqrt(*variance * more)});
    }
  }
  return summary;
}

}  // namespace walkgraph
