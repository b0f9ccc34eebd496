#ifndef WALKGRAPH_SOLVERS_BASELINES_FINGERPRINTS_H_
#define WALKGRAPH_SOLVERS_BASELINES_FINGERPRINTS_H_

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "data/time.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// A scan as a point in signal space: what was heard, everything else missing.
struct SignalVector {
  struct Entry {
    std::uint32_t transmitter = 0;  // index into Site::transmitters
    float rssi_dbm = 0;
  };
  std::vector<Entry> entries;
};

// A scan of the walk to be located; at the mean of the times heard.
struct QueryScan {
  TimeNs time_ns = 0;
  SignalVector signal;
};

// The scans of one radio in the evidence with their readings under `max_age_s` old that the site
// knows; scans without any are left out. In order of time.
std::vector<QueryScan> CollectQueryScans(const Site& site, const Evidence& evidence,
                                         double max_age_s, Radio radio = Radio::kWifi);

struct Neighbour {
  std::size_t fingerprint = 0;
  double distance_db = 0;  // Euclidean over all transmitters of the site
};

// What a search for neighbours may heed beyond the signals.
struct NeighbourSearch {
  // Every access point counts by the refresh rate (see RefreshRate) at the stronger of its two
  // signals: where both are weak, an old value or none at all says little.
  bool refresh_weights = false;
  // Only fingerprints for which this holds; empty: all.
  std::function<bool(std::size_t)> admits;
};

// The survey's Wi-Fi scans as fingerprints: readings under `max_age_s` old and not under
// `min_rssi_dbm`, placed at the mean of their readings' positions; restricted to one floor where it
// is given.
class Fingerprints {
 public:
  Fingerprints(const Site& site, std::optional<int> floor, double max_age_s, double missing_dbm,
               double min_rssi_dbm = -std::numeric_limits<double>::infinity());

  std::size_t size() const { return position_m_.size(); }
  const Eigen::Vector2d& position_m(std::size_t i) const { return position_m_[i]; }
  int floor(std::size_t i) const { return floor_[i]; }
  // Whether a transmitter is one of the two strongest that a fingerprint heard.
  bool StrongestInclude(std::size_t i, std::uint32_t transmitter) const {
    return strongest_[i][0] == transmitter || strongest_[i][1] == transmitter;
  }

  // The nearest `k` (or all, where there are fewer), nearest first; of equal ones the earlier
  // surveyed. Costs one product per stored reading: a missing signal is the origin, so that
  // |f - q|^2 = |f|^2 + |q|^2 - 2 f.q needs only what both heard.
  std::vector<Neighbour> Nearest(const SignalVector& query, std::size_t k,
                                 const NeighbourSearch& search = {}) const;

 private:
  // Squared distances in dB^2 of all fingerprints.
  std::vector<double> PlainDistances(const SignalVector& query) const;
  std::vector<double> RefreshWeightedDistances(const SignalVector& query) const;
  // Signals above the missing one by transmitter, zero where nothing was heard.
  std::vector<float> AboveMissing(const SignalVector& query) const;

  double missing_dbm_;
  std::size_t transmitter_count_;
  std::vector<std::size_t> begin_{0};         // of a fingerprint's entries; one more than there are
  std::vector<SignalVector::Entry> entries_;  // rssi above missing_dbm
  std::vector<std::array<std::uint32_t, 2>> strongest_;
  std::vector<double> squared_norm_;  // dB^2, from the missing signal
  std::vector<Eigen::Vector2d> position_m_;
  std::vector<int> floor_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_FINGERPRINTS_H_
