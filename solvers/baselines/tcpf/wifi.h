#ifndef WALKGRAPH_SOLVERS_BASELINES_TCPF_WIFI_H_
#define WALKGRAPH_SOLVERS_BASELINES_TCPF_WIFI_H_

#include <functional>
#include <vector>

#include "solvers/baselines/fingerprints.h"
#include "solvers/baselines/wknn.h"

namespace walkgraph {

struct TcpfWifiSettings {
  double rssi_static_dbm = -85;
  double rssi_moving_dbm = -75;
};

template <typename Visitor>
void Visit(Visitor& v, TcpfWifiSettings& s) {
  v.Field("rssi_static_dbm", s.rssi_static_dbm,
          "weaker signals count as missing while the person stands, dBm (the paper's best)");
  v.Field("rssi_moving_dbm", s.rssi_moving_dbm,
          "and while the person moves, dBm (the paper's best)");
}

// The fingerprints that speak for a place, nearest first.
struct WifiCandidates {
  const Fingerprints* fingerprints = nullptr;
  std::vector<Neighbour> nearest;

  bool empty() const { return nearest.empty(); }
  const Eigen::Vector2d& PositionOf(const Neighbour& neighbour) const {
    return fingerprints->position_m(neighbour.fingerprint);
  }
  // Weighted by 1/d. Precondition: not empty().
  Eigen::Vector2d Mean() const { return WknnFix(*fingerprints, nearest).position_m; }
};

// The paper's Wi-Fi positioning: WKNN with an RSSI threshold by motion state and, if asked for, AP
// matching. A signal under the threshold counts as missing and a missing one stands at the
// threshold, in query and fingerprint alike: at the threshold of -100 dBm this is WKNN.
class TcpfWifi {
 public:
  TcpfWifi(const Site& site, int floor, const TcpfWifiSettings& settings, const WknnSettings& wknn,
           bool match_strongest);

  bool empty() const { return static_.size() == 0 && moving_.size() == 0; }
  // The K nearest, of those positions alone that `admits` lets through (empty: all). None where
  // nothing reaches the threshold.
  WifiCandidates Find(const SignalVector& signal, bool moving,
                      const std::function<bool(const Eigen::Vector2d&)>& admits = {}) const;

 private:
  TcpfWifiSettings settings_;
  WknnSettings wknn_;
  bool match_strongest_;
  Fingerprints static_;
  Fingerprints moving_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_TCPF_WIFI_H_
