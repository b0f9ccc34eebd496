#ifndef WALKGRAPH_SOLVERS_BASELINES_TCPF_TRUST_CHAIN_H_
#define WALKGRAPH_SOLVERS_BASELINES_TCPF_TRUST_CHAIN_H_

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "data/angle.h"

namespace walkgraph {

// The trusted area: an annular sector about where dead reckoning leads, seen from the last
// position. Source: equation (15) of the TCPF paper.
struct TrustedArea {
  Eigen::Vector2d from_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d displacement_m = Eigen::Vector2d::Zero();  // as dead reckoned
  double distance_tolerance_m = 0;
  double direction_tolerance_rad = 0;

  // A point or a displacement without direction (under a millimetre) is judged by distance alone.
  bool Contains(const Eigen::Vector2d& point_m) const {
    constexpr double kNoDirectionM = 1e-3;
    const Eigen::Vector2d offset = point_m - from_m;
    const double reckoned_m = displacement_m.norm(), offset_m = offset.norm();
    if (std::abs(reckoned_m - offset_m) > distance_tolerance_m) return false;
    if (std::min(reckoned_m, offset_m) < kNoDirectionM) return true;
    const double turn = WrapAngle(std::atan2(offset.y(), offset.x()) -
                                  std::atan2(displacement_m.y(), displacement_m.x()));
    return std::abs(turn) <= direction_tolerance_rad;
  }
};

enum class TrustState : std::uint8_t { kTrustedLocked, kLocked, kUnlocked };

// The trust state and the TC parameter lambda, the mistrust of the last position: the weight of a
// Wi-Fi fix against dead reckoning's 1. Source: equations (16)-(19) of the TCPF paper.
class TrustChain {
 public:
  // alpha_per_m is the error that dead reckoning gathers in a metre over
  // the mean error of a fix. Unlocked where lambda is above `unlock_at`.
  TrustChain(double alpha_per_m, double unlock_at, TrustState state, double lambda)
      : alpha_per_m_(alpha_per_m), unlock_at_(unlock_at), state_(state), lambda_(lambda) {}

  TrustState state() const { return state_; }
  double lambda() const { return lambda_; }

  void Move(double distance_m) { lambda_ += alpha_per_m_ * distance_m; }

  Eigen::Vector2d Fuse(const Eigen::Vector2d& reckoned_m, const Eigen::Vector2d& fix_m) const {
    return reckoned_m + lambda_ / (1 + lambda_) * (fix_m - reckoned_m);
  }

  // After the fusion at a fix.
  void Settle(bool trusted) {
    // Doubly exponential where nothing is trusted; beyond this the weight is 1 to all digits.
    constexpr double kLargestLambda = 1e18;
    lambda_ = trusted ? 0.0 : std::min(lambda_ * (1 + lambda_), kLargestLambda);
    state_ = trusted                ? TrustState::kTrustedLocked
             : lambda_ > unlock_at_ ? TrustState::kUnlocked
                                    : TrustState::kLocked;
  }

 private:
  double alpha_per_m_;
  double unlock_at_;
  TrustState state_;
  double lambda_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_TCPF_TRUST_CHAIN_H_
