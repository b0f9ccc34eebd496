#include "solvers/baselines/fingerprints.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "factors/refresh_rate.h"
#include "frontends/radio_map/sweeps.h"

namespace walkgraph {
namespace {

// The transmitters of the two strongest entries, of equal ones the earlier; of one entry it twice.
std::array<std::uint32_t, 2> TwoStrongest(std::span<const SignalVector::Entry> entries) {
  std::size_t first = 0;
  for (std::size_t i = 1; i < entries.size(); ++i) {
    if (entries[i].rssi_dbm > entries[first].rssi_dbm) first = i;
  }
  std::size_t second = first;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i == first) continue;
    if (second == first || entries[i].rssi_dbm > entries[second].rssi_dbm) second = i;
  }
  return {entries[first].transmitter, entries[second].transmitter};
}

}  // namespace

std::vector<QueryScan> CollectQueryScans(const Site& site, const Evidence& evidence,
                                         double max_age_s, Radio radio) {
  const std::vector<std::int32_t> site_index = MatchTransmitters(site, evidence);
  std::vector<QueryScan> scans;
  for (const Sweep& sweep : GroupSweeps(evidence, radio)) {
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
                           double missing_dbm, double min_rssi_dbm)
    : missing_dbm_(missing_dbm), transmitter_count_(site.transmitters.size()) {
  for (const SurveyScan& scan : site.scans) {
    if (scan.radio != Radio::kWifi || (floor && scan.floor != *floor)) continue;
    Eigen::Vector2d position_sum = Eigen::Vector2d::Zero();
    double squared_norm = 0;
    for (const SurveyReading& reading : scan.readings) {
      if (reading.age_s >= max_age_s || reading.rssi_dbm < min_rssi_dbm) continue;
      const double above = reading.rssi_dbm - missing_dbm_;
      entries_.push_back({reading.transmitter, static_cast<float>(above)});
      squared_norm += above * above;
      position_sum += reading.position_m.cast<double>();
    }
    const std::size_t count = entries_.size() - begin_.back();
    if (count == 0) continue;
    strongest_.push_back(TwoStrongest(std::span(entries_).last(count)));
    begin_.push_back(entries_.size());
    squared_norm_.push_back(squared_norm);
    position_m_.push_back(position_sum / static_cast<double>(count));
    floor_.push_back(scan.floor);
  }
}

std::vector<float> Fingerprints::AboveMissing(const SignalVector& query) const {
  std::vector<float> above(transmitter_count_, 0.0F);
  for (const SignalVector::Entry& entry : query.entries) {
    above[entry.transmitter] = static_cast<float>(entry.rssi_dbm - missing_dbm_);
  }
  return above;
}

std::vector<double> Fingerprints::PlainDistances(const SignalVector& query) const {
  const std::vector<float> above = AboveMissing(query);
  double query_squared_norm = 0;
  for (const SignalVector::Entry& entry : query.entries) {
    const double value = entry.rssi_dbm - missing_dbm_;
    query_squared_norm += value * value;
  }
  std::vector<double> squared(size());
  for (std::size_t i = 0; i < size(); ++i) {
    double product = 0;
    for (std::size_t e = begin_[i]; e < begin_[i + 1]; ++e) {
      product += static_cast<double>(entries_[e].rssi_dbm) * above[entries_[e].transmitter];
    }
    squared[i] = squared_norm_[i] + query_squared_norm - 2 * product;
  }
  return squared;
}

std::vector<double> Fingerprints::RefreshWeightedDistances(const SignalVector& query) const {
  const RefreshRate refresh;
  const std::vector<float> above = AboveMissing(query);
  // What each signal of the query adds where a fingerprint did not hear it.
  std::vector<double> alone(transmitter_count_, 0.0);
  double all_alone = 0;
  for (const SignalVector::Entry& entry : query.entries) {
    const double value = above[entry.transmitter];
    alone[entry.transmitter] = refresh.Weight(entry.rssi_dbm) * value * value;
    all_alone += alone[entry.transmitter];
  }
  std::vector<double> squared(size(), all_alone);
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t e = begin_[i]; e < begin_[i + 1]; ++e) {
      const double ours = entries_[e].rssi_dbm, theirs = above[entries_[e].transmitter];
      const double weight = refresh.Weight(missing_dbm_ + std::max(ours, theirs));
      squared[i] += weight * (ours - theirs) * (ours - theirs) - alone[entries_[e].transmitter];
    }
  }
  return squared;
}

std::vector<Neighbour> Fingerprints::Nearest(const SignalVector& query, std::size_t k,
                                             const NeighbourSearch& search) const {
  const std::vector<double> squared =
      search.refresh_weights ? RefreshWeightedDistances(query) : PlainDistances(query);
  std::vector<Neighbour> neighbours;
  neighbours.reserve(size());
  for (std::size_t i = 0; i < size(); ++i) {
    if (search.admits && !search.admits(i)) continue;
    neighbours.push_back({i, std::sqrt(std::max(0.0, squared[i]))});
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
