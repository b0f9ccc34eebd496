#include "solvers/baselines/dsff/extended_map.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "factors/map_sweeps.h"
#include "frontends/radio_map/hearing.h"
#include "solvers/baselines/discrete.h"
#include "solvers/baselines/floor_likelihood.h"
#include "solvers/baselines/likelihood_grid.h"

namespace walkgraph {
namespace {

RadioMap Restrict(const RadioMap& map, const std::vector<bool>& selected) {
  RadioMap restricted = map;
  std::erase_if(restricted.fields, [&](const RadioMap::TransmitterField& field) {
    return !selected[field.transmitter];
  });
  restricted.silence_nats = SilenceField(restricted.grid, restricted.fields);
  return restricted;
}

// Mean and squared deviations of a magnetic sample's two numbers.
struct MagneticMoments {
  double count = 0;
  Eigen::Array2d sum = Eigen::Array2d::Zero(), squares = Eigen::Array2d::Zero();

  void Add(const Eigen::Array2d& value) {
    ++count;
    sum += value;
    squares += value * value;
  }
  Eigen::Array2d Mean() const { return sum / count; }
  Eigen::Array2d Deviations() const { return (squares - sum * sum / count).max(0.0); }
};

Eigen::Array2d NumbersOf(const SurveyMagnetic& sample) {
  return {sample.norm_ut, sample.inclination_rad};
}

double LogNormal(double deviation, double variance) {
  return -0.5 * (deviation * deviation / variance + std::log(variance));
}

}  // namespace

std::vector<bool> SelectAccessPoints(const Site& site, int count, double missing_dbm) {
  std::vector<bool> selected(site.transmitters.size(), count <= 0);
  if (count <= 0) return selected;
  std::vector<double> sum(site.transmitters.size(), 0.0), squares = sum;
  double scans = 0;
  for (const SurveyScan& scan : site.scans) {
    if (scan.radio != Radio::kWifi) continue;
    ++scans;
    for (const SurveyReading& reading : scan.readings) {
      const double above = reading.rssi_dbm - missing_dbm;
      sum[reading.transmitter] += above;
      squares[reading.transmitter] += above * above;
    }
  }
  std::vector<std::size_t> order(sum.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto variance = [&](std::size_t t) { return squares[t] - sum[t] * sum[t] / scans; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return variance(a) > variance(b); });
  order.resize(std::min(order.size(), static_cast<std::size_t>(count)));
  for (const std::size_t t : order) selected[t] = true;
  return selected;
}

MagneticEmission::MagneticEmission(const Site& site, const DsffCells& cells,
                                   const ExtendedMapSettings& settings) {
  std::vector<MagneticMoments> near(cells.size());
  std::vector<MagneticMoments> floors(cells.floors().size());
  for (std::size_t f = 0; f < cells.floors().size(); ++f) {
    const DsffCells::FloorCells& floor = cells.floors()[f];
    for (const SurveyMagnetic& sample : site.magnetic) {
      if (sample.floor != floor.floor) continue;
      const Eigen::Array2d numbers = NumbersOf(sample);
      floors[f].Add(numbers);
      floor.points.ForNear(
          sample.position_m.cast<double>(), settings.magnetic_radius_m,
          [&](int point) { near[floor.begin + static_cast<std::size_t>(point)].Add(numbers); });
    }
  }
  Eigen::Array2d pooled = Eigen::Array2d::Zero();
  double degrees_of_freedom = 0;
  for (const MagneticMoments& cell : near) {
    if (cell.count < 2) continue;
    pooled += cell.Deviations();
    degrees_of_freedom += cell.count - 1;
  }
  if (degrees_of_freedom == 0 || !(pooled > 0).all()) return;
  pooled /= degrees_of_freedom;
  const double prior = settings.magnetic_prior_samples;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const MagneticMoments& cell = near[c];
    const MagneticMoments& floor = floors[static_cast<std::size_t>(
        &cells.FloorOf(static_cast<int>(c)) - cells.floors().data())];
    Eigen::Array2d mean = Eigen::Array2d::Zero(), variance = pooled;
    if (cell.count > 0) {
      mean = cell.Mean();
      variance =
          (prior * pooled + cell.Deviations()) / (prior + cell.count - 1) * (1 + 1 / cell.count);
    } else if (floor.count > 0) {
      mean = floor.Mean();
      variance = pooled + floor.Deviations() / floor.count;
    }
    densities_.push_back({mean(0), variance(0), mean(1), variance(1)});
  }
}

void MagneticEmission::Add(const MagneticSample& sample,
                           std::vector<double>* log_likelihood) const {
  for (std::size_t c = 0; c < densities_.size(); ++c) {
    const Density& density = densities_[c];
    (*log_likelihood)[c] +=
        LogNormal(sample.norm_ut - density.norm_ut, density.norm_variance) +
        LogNormal(sample.inclination_rad - density.inclination_rad, density.inclination_variance);
  }
}

namespace {

// Gathers what is said about each epoch.
class Gatherer {
 public:
  Gatherer(const Site& site, const Evidence& evidence, const DsffCells& cells,
           std::vector<TimeNs> epochs, const FactorSettings& factors)
      : site_(site), evidence_(evidence), cells_(cells), factors_(factors) {
    result_.log_likelihood.assign(epochs.size(), std::vector<double>(cells.size(), 0.0));
    result_.time_ns = std::move(epochs);
  }

  void AddRadio(const RadioMap& map, const DsffCells::FloorCells& floor) {
    const LikelihoodGrid grid(map, floor.points.positions_m(),
                              PriorOfRssiOffset(site_, evidence_, map.radio, factors_.rssi_offset),
                              factors_.fingerprint.loss);
    const std::vector<MapSweep> sweeps =
        CollectMapSweeps(site_, map, evidence_, factors_.fingerprint);
    const std::vector<std::vector<float>> nats = grid.Evaluate(sweeps);
    for (std::size_t s = 0; s < sweeps.size(); ++s) {
      std::vector<double>& sum = EpochAt(sweeps[s].mean_heard_ns);
      for (std::size_t i = 0; i < nats[s].size(); ++i) sum[floor.begin + i] -= nats[s][i];
    }
  }

  // What is said about places on each floor loses what it says about the floor.
  void NormaliseFloors() {
    for (std::vector<double>& values : result_.log_likelihood) {
      for (const DsffCells::FloorCells& floor : cells_.floors()) {
        const std::span<double> own = std::span(values).subspan(floor.begin, floor.points.size());
        const double mean = LogSumExp(own) - std::log(static_cast<double>(own.size()));
        for (double& value : own) value -= mean;
      }
    }
  }

  void AddFloors() {
    std::vector<int> floors;
    for (const DsffCells::FloorCells& floor : cells_.floors()) floors.push_back(floor.floor);
    for (const FloorLook& look : FloorSounds(site_, factors_).Looks(evidence_, floors)) {
      std::vector<double>& values = EpochAt(look.mean_heard_ns);
      for (std::size_t f = 0; f < floors.size(); ++f) {
        const DsffCells::FloorCells& floor = cells_.floors()[f];
        for (std::size_t i = 0; i < floor.points.size(); ++i) {
          values[floor.begin + i] += look.log_likelihood(static_cast<Eigen::Index>(f));
        }
      }
    }
  }

  void AddMagnetic(const MagneticEmission& emission) {
    constexpr TimeNs kHalfSample = kNsPerSecond / 4;  // as in the survey
    for (std::size_t e = 0; e < result_.time_ns.size(); ++e) {
      const TimeNs time = result_.time_ns[e];
      const auto field = MeanField(evidence_.magnetic, time - kHalfSample, time + kHalfSample);
      if (field) emission.Add(*field, &result_.log_likelihood[e]);
    }
  }

  AbsoluteEvidence Take() { return std::move(result_); }

 private:
  std::vector<double>& EpochAt(TimeNs time_ns) {
    return result_.log_likelihood[NearestTime(result_.time_ns, time_ns)];
  }

  const Site& site_;
  const Evidence& evidence_;
  const DsffCells& cells_;
  const FactorSettings& factors_;
  AbsoluteEvidence result_;
};

}  // namespace

AbsoluteEvidence GatherAbsoluteEvidence(const Site& site, const Evidence& evidence,
                                        const DsffCells& cells, std::vector<TimeNs> epochs,
                                        const FactorSettings& factors,
                                        const ExtendedMapSettings& settings, double missing_dbm) {
  Gatherer gatherer(site, evidence, cells, std::move(epochs), factors);
  const std::vector<bool> selected = SelectAccessPoints(site, settings.ap_count, missing_dbm);
  for (const DsffCells::FloorCells& floor : cells.floors()) {
    for (const Radio radio : kAllRadios) {
      const RadioMap* map = site.FindMap(floor.floor, radio);
      if (map == nullptr || !factors.fingerprint.Uses(radio)) continue;
      const bool restricts = radio == Radio::kWifi && settings.ap_count > 0;
      gatherer.AddRadio(restricts ? Restrict(*map, selected) : *map, floor);
    }
  }
  if (cells.floors().size() > 1) {
    gatherer.NormaliseFloors();
    gatherer.AddFloors();
  }
  if (settings.use_magnetic) {
    const MagneticEmission magnetic(site, cells, settings);
    if (!magnetic.empty()) gatherer.AddMagnetic(magnetic);
  }
  return gatherer.Take();
}

}  // namespace walkgraph
