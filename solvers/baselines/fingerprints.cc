#include "solvers/baselines/fingerprints.h"

#include <algorithm>
#include <cmath>

#include "frontends/radio_map/sweeps.h"

namespace walkgraph {

std::vector<QueryScan> CollectQueryScans(const Site& site, const Evidence& evidence,
                                         double max_age_s) {
  const std::vector<std::int32_t> site_index = MatchTransmitters(site, evidence);
  std::vector<QueryScan> scans;
  for (const Sweep& sweep : GroupSweeps(evidence, Radio::kWifi)) {
    QueryScan scan;
    const TimeNs origin = sweep.mean_heard_ns;
    TimeNs sum_ns = 0;
    for (const std::size_t i : sweep.readings) {
      const RadioReading& reading = evidence.readings[i];
      const std::int32_t transmitter = site_index[reading.transmitter];
      if (transmitter == kUnknownTransmitter) continue;
      if (SecondsBetween(reading.heard_ns, reading.printed_ns) >= max_age_s) continue;
      scan.signal.entries.push_back({static_cast<std::uint32_t>(transmitter), reading.rssi_dbm});
      sum_ns += reading.heard_ns - origin;
    }
    if (scan.signal.entries.empty()) continue;
    scan.time_ns = origin + sum_ns / static_cast<TimeNs>(scan.signal.entries.size());
    scans.push_back(std::move(scan));
  }
  std::stable_sort(scans.begin(), scans.end(),
                   [](const QueryScan& a, const QueryScan& b) { return a.time_ns < b.time_ns; });
  return scans;
}

Fingerprints::Fingerprints(const Site& site, std::optional<int> floor, double max_age_s,
                           double missing_dbm)
    : missing_dbm_(missing_dbm), transmitter_count_(site.transmitters.size()) {
  for (const SurveyScan& scan : site.scans) {
    if (scan.radio != Radio::kWifi || (floor && scan.floor != *floor)) continue;
    Eigen::Vector2d position_sum = Eigen::Vector2d::Zero();
    double squared_norm = 0;
    for (const SurveyReading& reading : scan.readings) {
      if (reading.age_s >= max_age_s) continue;
      const double above = reading.rssi_dbm - missing_dbm_;
      entries_.push_back({reading.transmitter, static_cast<float>(above)});
      squared_norm += above * above;
      position_sum += reading.position_m.cast<double>();
    }
    const std::size_t count = entries_.size() - begin_.back();
    if (count == 0) continue;
    begin_.push_back(entries_.size());
    squared_norm_.push_back(squared_norm);
    position_m_.push_back(position_sum / static_cast<double>(count));
    floor_.push_back(scan.floor);
  }
}

std::vector<Neighbour> Fingerprints::Nearest(const SignalVector& query, std::size_t k) const {
  std::vector<float> above(transmitter_count_, 0.0F);
  double query_squared_norm = 0;
  for (const SignalVector::Entry& entry : query.entries) {
    const double value = entry.rssi_dbm - missing_dbm_;
    above[entry.transmitter] = static_cast<float>(value);
    query_squared_norm += value * value;
  }
  std::vector<Neighbour> neighbours(size());
  for (std::size_t i = 0; i < size(); ++i) {
    double product = 0;
    for (std::size_t e = begin_[i]; e < begin_[i + 1]; ++e) {
      product += static_cast<double>(entries_[e].rssi_dbm) * above[entries_[e].transmitter];
    }
    const double squared = squared_norm_[i] + query_squared_norm - 2 * product;
    neighbours[i] = {i, std::sqrt(std::max(0.0, squared))};
  }
  const std::size_t count = std::min(k, neighbours.size());
  std::partial_sort(neighbours.begin(), neighbours.begin() + static_cast<std::ptrdiff_t>(count),
                    neighbours.end(), [](const Neighbour& a, const Neighbour& b) {
                      return a.distance_db != b.distance_db ? a.distance_db < b.distance_db
                                                            : a.fingerprint < b.fingerprint;
                    });
  neighbours.resize(count);
  return neighbours;
}

}  // namespace walkgraph
