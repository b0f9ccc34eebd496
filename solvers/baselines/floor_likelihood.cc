#include "solvers/baselines/floor_likelihood.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "frontends/radio_map/sweeps.h"

namespace walkgraph {
namespace {

// A difference of more than five spreads says no more than one of five: an access point moved.
constexpr double kMostSquares = 25.0;

class MeanSignals {
 public:
  void Add(std::uint32_t transmitter, double rssi_dbm) {
    auto& [sum, count] = sums_[transmitter];
    sum += rssi_dbm;
    ++count;
  }
  std::vector<std::pair<std::uint32_t, float>> Means() const {
    std::vector<std::pair<std::uint32_t, float>> means;
    for (const auto& [transmitter, sum] : sums_) {
      means.emplace_back(transmitter, static_cast<float>(sum.first / sum.second));
    }
    return means;
  }

 private:
  std::map<std::uint32_t, std::pair<double, int>> sums_;
};

std::int64_t Stretch(TimeNs time_ns, TimeNs origin_ns, double length_s) {
  return static_cast<std::int64_t>(std::floor(SecondsBetween(origin_ns, time_ns) / length_s));
}

// Capped squares of the strengths of one look against those of another.
class Comparison {
 public:
  Comparison(std::size_t transmitters, const FloorSettings& settings,
             const std::vector<std::pair<std::uint32_t, float>>& heard)
      : settings_(settings), rssi_dbm_(transmitters, settings.missing_dbm) {
    for (const auto& [transmitter, rssi_dbm] : heard) {
      // Signals under the missing one are as good as missing.
      rssi_dbm_[transmitter] = std::max<double>(rssi_dbm, settings.missing_dbm);
      alone_ += Capped(rssi_dbm_[transmitter] - settings.missing_dbm);
    }
  }

  double Squares(const std::vector<std::pair<std::uint32_t, float>>& other) const {
    double sum = alone_;
    for (const auto& [transmitter, rssi_dbm] : other) {
      const double theirs = std::max<double>(rssi_dbm, settings_.missing_dbm);
      const double ours = rssi_dbm_[transmitter];
      sum += Capped(ours - theirs) - Capped(ours - settings_.missing_dbm);
    }
    return sum;
  }

 private:
  double Capped(double difference_db) const {
    const double z = difference_db / settings_.spread_db;
    return std::min(z * z, kMostSquares);
  }

  const FloorSettings& settings_;
  std::vector<double> rssi_dbm_;
  double alone_ = 0;  // squares against a look that heard nothing
};

}  // namespace

FloorSounds::FloorSounds(const Site& site, const FactorSettings& settings)
    : site_(site), settings_(settings) {
  using Key = std::tuple<std::uint32_t, int, Radio, std::int64_t>;  // walk, floor, radio, stretch
  std::map<Key, MeanSignals> looks;
  for (const SurveyScan& scan : site.scans) {
    const std::int64_t stretch =
        Stretch(scan.printed_ns, site.scans.front().printed_ns, settings.floor.correlation_s);
    MeanSignals& look = looks[{scan.walk, scan.floor, scan.radio, stretch}];
    for (const SurveyReading& reading : scan.readings) {
      look.Add(reading.transmitter, reading.rssi_dbm);
    }
  }
  for (const auto& [key, look] : looks) {
    survey_.push_back({std::get<1>(key), std::get<2>(key), look.Means()});
  }
}

Eigen::VectorXd FloorSounds::LogPrior(const std::vector<int>& floors) const {
  Eigen::VectorXd count = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(floors.size()));
  for (const SurveyLook& look : survey_) {
    const auto floor = std::find(floors.begin(), floors.end(), look.floor);
    if (floor != floors.end()) ++count[floor - floors.begin()];
  }
  return (count / count.sum()).array().log();
}

std::vector<FloorLook> FloorSounds::Looks(const Evidence& evidence,
                                          const std::vector<int>& floors) const {
  std::vector<FloorLook> looks;
  for (const Radio radio : kAllRadios) {
    if (settings_.fingerprint.Uses(radio)) AppendLooks(evidence, radio, floors, &looks);
  }
  std::stable_sort(looks.begin(), looks.end(), [](const FloorLook& a, const FloorLook& b) {
    return a.mean_heard_ns < b.mean_heard_ns;
  });
  return looks;
}

void FloorSounds::AppendLooks(const Evidence& evidence, Radio radio, const std::vector<int>& floors,
                              std::vector<FloorLook>* looks) const {
  const std::vector<std::int32_t> site_index = MatchTransmitters(site_, evidence);
  const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(floors.size()));
  std::int64_t stretch = -1;
  MeanSignals signals;             // of the stretch so far
  Eigen::VectorXd said = nothing;  // by the stretch so far
  for (const Sweep& sweep : GroupSweeps(evidence, radio)) {
    const std::int64_t at =
        Stretch(sweep.mean_heard_ns, evidence.begin_ns, settings_.floor.correlation_s);
    if (at != stretch) {
      stretch = at;
      signals = {};
      said = nothing;
    }
    FloorLook look{sweep.mean_heard_ns, sweep.mean_heard_ns, {}};
    for (const std::size_t i : sweep.readings) {
      const RadioReading& reading = evidence.readings[i];
      look.printed_ns = std::max(look.printed_ns, reading.printed_ns);
      const std::int32_t transmitter = site_index[reading.transmitter];
      if (transmitter == kUnknownTransmitter) continue;
      signals.Add(static_cast<std::uint32_t>(transmitter), reading.rssi_dbm);
    }
    const Signals heard = signals.Means();
    if (heard.empty()) continue;
    const Eigen::VectorXd now = LogLikelihood(radio, floors, heard);
    look.log_likelihood = now - said;
    said = now;
    looks->push_back(std::move(look));
  }
}

Eigen::VectorXd FloorSounds::LogLikelihood(Radio radio, const std::vector<int>& floors,
                                           const Signals& heard) const {
  const Comparison comparison(site_.transmitters.size(), settings_.floor, heard);
  const double weight = std::min(1.0, settings_.floor.n_eff / static_cast<double>(heard.size()));
  std::vector<std::pair<int, double>> nats;  // floor and cost of each look of the survey
  double least = std::numeric_limits<double>::infinity();
  for (const SurveyLook& look : survey_) {
    if (look.radio != radio) continue;
    nats.emplace_back(look.floor, 0.5 * weight * comparison.Squares(look.signals));
    least = std::min(least, nats.back().second);
  }
  std::map<int, double> densities, counts;
  double everywhere = 0;
  for (const auto& [floor, value] : nats) {
    const double density = std::exp(least - value);
    densities[floor] += density;
    ++counts[floor];
    everywhere += density;
  }
  Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(floors.size()));
  if (nats.empty()) return result;
  const double share = settings_.floor.background;
  for (std::size_t f = 0; f < floors.size(); ++f) {
    result[static_cast<Eigen::Index>(f)] =
        std::log((densities[floors[f]] + share * everywhere) /
                 (counts[floors[f]] + share * static_cast<double>(nats.size())));
  }
  return result;
}

}  // namespace walkgraph
