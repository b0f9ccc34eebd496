#include "solvers/baselines/tcpf/wifi.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace walkgraph {
namespace {

Fingerprints AtLeast(double rssi_dbm, const Site& site, int floor, const WknnSettings& wknn) {
  return {site, floor, wknn.max_age_s, rssi_dbm, rssi_dbm};
}

std::uint32_t Strongest(const SignalVector& signal) {
  return std::max_element(signal.entries.begin(), signal.entries.end(),
                          [](const SignalVector::Entry& a, const SignalVector::Entry& b) {
                            return a.rssi_dbm < b.rssi_dbm;
                          })
      ->transmitter;
}

}  // namespace

TcpfWifi::TcpfWifi(const Site& site, int floor, const TcpfWifiSettings& settings,
                   const WknnSettings& wknn, bool match_strongest)
    : settings_(settings),
      wknn_(wknn),
      match_strongest_(match_strongest),
      static_(AtLeast(settings.rssi_static_dbm, site, floor, wknn)),
      moving_(AtLeast(settings.rssi_moving_dbm, site, floor, wknn)) {}

WifiCandidates TcpfWifi::Find(const SignalVector& signal, bool moving,
                              const std::function<bool(const Eigen::Vector2d&)>& admits) const {
  const Fingerprints& fingerprints = moving ? moving_ : static_;
  WifiCandidates candidates{&fingerprints, {}};
  const double threshold_dbm = moving ? settings_.rssi_moving_dbm : settings_.rssi_static_dbm;
  SignalVector strong;
  for (const SignalVector::Entry& entry : signal.entries) {
    if (entry.rssi_dbm >= threshold_dbm) strong.entries.push_back(entry);
  }
  if (strong.entries.empty()) return candidates;

  const auto k = static_cast<std::size_t>(std::max(1, wknn_.k));
  const std::uint32_t strongest = Strongest(strong);
  const auto in_area = [&](std::size_t i) { return !admits || admits(fingerprints.position_m(i)); };
  const auto matches = [&](std::size_t i) {
    return fingerprints.StrongestInclude(i, strongest) && in_area(i);
  };
  if (match_strongest_) {
    candidates.nearest = fingerprints.Nearest(strong, k, {wknn_.refresh_weights, matches});
  }
  if (candidates.empty()) {
    candidates.nearest = fingerprints.Nearest(strong, k, {wknn_.refresh_weights, in_area});
  }
  return candidates;
}

}  // namespace walkgraph
