#ifndef WALKGRAPH_SOLVERS_BASELINES_TCPF_FUSION_H_
#define WALKGRAPH_SOLVERS_BASELINES_TCPF_FUSION_H_

#include <vector>

#include "factors/dead_reckoning.h"
#include "solvers/baselines/fixes.h"
#include "solvers/baselines/tcpf/heading_filter.h"
#include "solvers/baselines/tcpf/trust_chain.h"
#include "solvers/baselines/tcpf/wifi.h"

namespace walkgraph {

struct TcpfSettings {
  TcpfWifiSettings wifi;
  HeadingFilterSettings heading;
  double distance_tolerance_m = 2;
  double direction_tolerance_rad = 0.785398163397448;  // 45 degrees
  double unlock_at = 1;
  double pdr_error_per_m = 0.119567;  // 8.9675 cm in a step of 75 cm
  double wifi_error_m = 2.68;
};

template <typename Visitor>
void Visit(Visitor& v, TcpfSettings& s) {
  v.Group("wifi", s.wifi);
  v.Group("heading", s.heading);
  v.Field("distance_tolerance_m", s.distance_tolerance_m,
          "half width of the trusted area along the way, m (the paper's)");
  v.Field("direction_tolerance_rad", s.direction_tolerance_rad,
          "half angle of the trusted area, rad (the paper's 45 degrees)");
  v.Field("unlock_at", s.unlock_at, "mistrust above which the chain is unlocked (the paper's)");
  v.Field("pdr_error_per_m", s.pdr_error_per_m,
          "error that dead reckoning gathers in a metre, m (the paper's)");
  v.Field("wifi_error_m", s.wifi_error_m, "mean error of a Wi-Fi fix, m (the paper's)");
}

// A Wi-Fi scan and what dead reckoning says at its time.
struct TcpfEpoch {
  QueryScan scan;
  bool moving = true;
  Eigen::Vector2d reckoned_m = Eigen::Vector2d::Zero();  // from an arbitrary origin
  double walked_m = 0;                                   // along the way, since the beginning
};

std::vector<TcpfEpoch> CollectEpochs(const Evidence& evidence, const DeadReckonedPath& path,
                                     std::vector<QueryScan> scans);

// A position and whether the method took it for an anchor: a trusted point, an accepted fix.
struct TcpfPosition {
  TimeNs time_ns = 0;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  bool trusted = false;
};

// Wi-Fi alone: a position per epoch at which a signal reaches the threshold.
std::vector<TcpfPosition> LocateByWifi(const std::vector<TcpfEpoch>& epochs, const TcpfWifi& wifi);

// Trust chain fusion. Nothing before the first fix, which is the first position.
std::vector<TcpfPosition> FuseByTrust(const std::vector<TcpfEpoch>& epochs, const TcpfWifi& wifi,
                                      const TcpfSettings& settings);

// The cross-assistive rival (Miyazaki et al., as the TCPF paper tells of it): only fingerprints in
// the trusted area seen from the last accepted fix are searched; a fix inside the area is accepted
// and resets dead reckoning, which goes on alone otherwise.
std::vector<TcpfPosition> FuseByCrossAssistance(const std::vector<TcpfEpoch>& epochs,
                                                const TcpfWifi& wifi, const TcpfSettings& settings);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_TCPF_FUSION_H_
