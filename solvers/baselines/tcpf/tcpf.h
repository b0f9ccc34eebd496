#ifndef WALKGRAPH_SOLVERS_BASELINES_TCPF_TCPF_H_
#define WALKGRAPH_SOLVERS_BASELINES_TCPF_TCPF_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "factors/settings.h"
#include "solvers/baselines/dead_reckoning.h"
#include "solvers/baselines/description.h"
#include "solvers/baselines/tcpf/fusion.h"
#include "solvers/baselines/wknn.h"
#include "solvers/estimator.h"

namespace walkgraph {

enum class TcpfVariant : std::uint8_t {
  kThreshold,         // Wi-Fi alone, RSSI threshold by motion state
  kThresholdApMatch,  // and AP matching
  kDeadReckoning,     // steps and filtered heading alone
  kCrossAssistive,
  kTrustChain,
};

struct TcpfMethod {
  TcpfVariant variant = TcpfVariant::kTrustChain;
  MethodDescription description;
};

inline constexpr std::string_view kTcpfSource =
    "Trust Chain Positioning Fusion (TCPF), Sensors 15 (2015)";
inline constexpr std::string_view kTcpfWifiChoices =
    "standing as the shared motion frontend says (the paper's thresholds of acceleration are not "
    "printed). A signal under the threshold counts as missing in scan and fingerprint, and a "
    "missing one stands at the threshold; scans without any stronger one give no fix. K of wknn";
inline constexpr std::string_view kTcpfHeadingChoices =
    "compass: the evidence's absolute heading, plus the calibrated mean offset; spreads of the "
    "heading filter; steps and the calibrated mean step scale of the shared frontend (same length "
    "model as the paper's). Started like pdr";
inline constexpr std::string_view kTcpfFusionChoices =
    "as tcpf_wknn_thr_ap and tcpf_pdr. Begins unlocked at the first fix with lambda = 1. Locked: "
    "those of the K nearest that lie in the trusted area, dead reckoning alone where none does, "
    "which counts as an untrusted fusion. No direction is judged under 1 mm. alpha and tolerances "
    "are the paper's, not calibrated. Linear in time between scans; no covariance";

// Every one of them, in the order of the paper's figures.
inline constexpr TcpfMethod kTcpfMethods[] = {
    {TcpfVariant::kThreshold,
     {"tcpf_wknn_thr", "WKNN with a threshold on RSSI by motion state", kTcpfSource,
      kTcpfWifiChoices}},
    {TcpfVariant::kThresholdApMatch,
     {"tcpf_wknn_thr_ap", "and only among fingerprints whose two strongest APs have the scan's",
      kTcpfSource, kTcpfWifiChoices}},
    {TcpfVariant::kDeadReckoning,
     {"tcpf_pdr", "steps in the direction of a Kalman filter of gyroscope and compass", kTcpfSource,
      kTcpfHeadingChoices}},
    {TcpfVariant::kCrossAssistive,
     {"tcpf_cross_assistive", "Wi-Fi searched where dead reckoning leads, which its fixes reset",
      "Miyazaki et al., as told in TCPF, Sensors 15 (2015)",
      "as tcpf_wknn_thr_ap and tcpf_pdr. Search area: TCPF's trusted area seen from the last "
      "accepted fix; a fix inside it is accepted. Begins at the first fix. No covariance"}},
    {TcpfVariant::kTrustChain,
     {"tcpf", "trust chain fusion of Wi-Fi fixes and dead reckoning", kTcpfSource,
      kTcpfFusionChoices}},
};

// TCPF and what its paper compares it with. Unsupported without accelerometer, and but for Wi-Fi
// alone without gyroscope or absolute heading. The fusions' slow states hold kTrustedState
// at every scan.
class TcpfEstimator : public Estimator {
 public:
  TcpfEstimator(const TcpfMethod& method, const TcpfSettings& settings,
                const DeadReckoningSettings& pdr, const WknnSettings& wknn,
                const FactorSettings& factors)
      : method_(method), settings_(settings), pdr_(pdr), wknn_(wknn), factors_(factors) {}
  std::string_view name() const override { return method_.description.name; }
  EstimateResult Estimate(const Site& site, const Evidence& evidence) const override;

 private:
  bool IsWifiAlone() const {
    return method_.variant == TcpfVariant::kThreshold ||
           method_.variant == TcpfVariant::kThresholdApMatch;
  }
  // What the walk lacks; empty where it has everything.
  std::string Lack(const Evidence& evidence) const;
  EstimateResult Locate(const Site& site, const Evidence& evidence) const;
  std::vector<TcpfPosition> Solve(const std::vector<TcpfEpoch>& epochs, const TcpfWifi& wifi) const;

  TcpfMethod method_;
  TcpfSettings settings_;
  DeadReckoningSettings pdr_;
  WknnSettings wknn_;
  FactorSettings factors_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_TCPF_TCPF_H_
